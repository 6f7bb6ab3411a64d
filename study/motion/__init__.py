"""Steps of the study about motions on N⁴: work and precision, and stability where methods fail."""
