"""How much an audit notices: one token of a paper's source is changed at a time."""
