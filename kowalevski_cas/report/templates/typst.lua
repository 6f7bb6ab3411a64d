-- Turns what the report's macros leave for pandoc into calls of the functions in report.typ.

local function typst(text) return pandoc.RawInline("typst", text) end
local function block(text) return pandoc.RawBlock("typst", text) end

local function wrapped(before, blocks, after)
  local out = pandoc.List({ block(before) })
  out:extend(blocks)
  out:insert(block(after))
  return out
end

local marks = { sign = '#sign("%s");', word = '#word("%s");', margin = '#margin("%s", 2.2em);',
  row = '#margin("%s", 4.2em);', group = "#group;" }

function Span(span)
  local kind, name = pandoc.utils.stringify(span):match("^(%l+):(%l*)$")
  if span.classes:includes("sans-serif") and marks[kind] then
    return typst((marks[kind]:gsub("%%s", name)))
  end
end

-- a formula on lines of its own, or in a cell of a table
function Math(math)
  if math.mathtype == "DisplayMath" then
    return { typst("#display["), math, typst("]") }
  end
  local formula, marked = math.text:gsub("^%s*\\displaystyle%s*", "")
  if marked == 1 then
    return { typst("#cell["), pandoc.Math("DisplayMath", formula), typst("]") }
  end
end

-- what begins a claim, and what leads to a display, stays with what follows
function Para(para)
  local out, line, claim = pandoc.List(), pandoc.List(), false
  local function flush(wrapper)
    out:insert(block("#" .. wrapper .. "["))
    out:insert(pandoc.Para(line))
    out:insert(block("]"))
    line, claim = pandoc.List(), false
  end
  for place, inline in ipairs(para.content) do
    local raw = inline.t == "RawInline" and inline.text or ""
    if raw == "#display[" and #line > 0 then
      flush(claim and "claim" or "before")
    end
    claim = claim or (place == 1 and (raw:match("^#margin") or raw == "#group;"))
    line:insert(inline)
  end
  if claim then
    flush("claim")
  elseif #out > 0 then
    out:insert(pandoc.Para(line))
  end
  return #out > 0 and out or nil
end

-- columns that are given in parts of the line fill the line
function Table(tab)
  local sum = 0
  for _, spec in ipairs(tab.colspecs) do
    sum = sum + (tonumber(spec[2]) or 100)
  end
  if sum > 0.9 and sum < 1 then
    for _, spec in ipairs(tab.colspecs) do
      spec[2] = spec[2] / sum
    end
    return tab
  end
end

local around = {
  opening = { "#v(6mm)", "#v(8mm)" },
  titling = { '#block(below: 1.4em, text(1.72em, weight: "bold", par(justify: false)[', "]))" },
  byline = { "#block(below: 1em, text(1.2em)[", "])" },
  origin = { "#block(text(0.9em)[#emph[", "]])" },
  lead = { "#block(below: 1.5em, text(1.2em, par(justify: false)[", "]))" },
  aside = { "#aside[", "]" },
  columns = { "#ruled[", "]" },
  rows = { "#rows[", "]" },
  evidence = { "#evidence[", "]" },
  intro = { "#before[", "]" },
  plate = { "#block(breakable: false, above: 2em)[", "]" },
  shown = { "#block(breakable: false, above: 1.8em)[#set text(0.9em)\n", "]" },
  picturing = { "#block(above: 1em, below: 1em)[", "]" },
}

function Div(div)
  for _, class in ipairs(div.classes) do
    if class == "rows" then -- the id stands beside the middle of the formula
      local text = pandoc.write(pandoc.Pandoc(div.content), "typst")
      return block("#rows[\n" .. text:gsub("align: %(left,left,left,%)", "align: left + horizon") .. "\n]")
    elseif around[class] then
      return wrapped(around[class][1], div.content, around[class][2])
    end
  end
end
