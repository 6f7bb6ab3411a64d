-- Turns what the report's macros leave for pandoc into calls of the functions in report.typ.

local function typst(text) return pandoc.RawInline("typst", text) end
local function block(text) return pandoc.RawBlock("typst", text) end

local function wrapped(before, blocks, after)
  local out = pandoc.List({ block(before) })
  out:extend(blocks)
  out:insert(block(after))
  return out
end

local marks = {
  sign = '#sign("%s")',
  word = '#word("%s")',
  margin = '#apart()#margin("%s", 2.2em)',
  row = '#margin("%s", 4.2em)',
  group = "#apart()",
}

function Span(span)
  local kind, name = pandoc.utils.stringify(span):match("^(%l+):(%l*)$")
  if span.classes:includes("sans-serif") and marks[kind] then
    return typst((marks[kind]:gsub("%%s", name)) .. ";")
  end
end

local around = {
  opening = { "#v(6mm)", "#v(8mm)" },
  titling = { '#block(below: 1.2em, text(1.72em, weight: "bold", par(justify: false)[', "]))" },
  byline = { "#text(1.2em)[", "]" },
  origin = { "#block(text(0.9em)[#emph[", "]])" },
  lead = { "#block(text(1.2em, par(justify: false)[", "]))" },
  aside = { "#aside[", "]" },
  columns = { "#ruled[", "]" },
  rows = { "#rows[", "]" },
  evidence = { "#evidence[", "]" },
  picturing = { "#block(above: 1em, below: 1em)[", "]" },
}

function Div(div)
  for _, class in ipairs(div.classes) do
    if around[class] then
      return wrapped(around[class][1], div.content, around[class][2])
    end
  end
end

function RawBlock(raw)
  if raw.format:match("tex") and raw.text:match("\\newpage") then return block("#pagebreak()") end
end
