// Numbers are sums of rational multiples of roots of whole numbers without square factors, as a map
// from the number below the root to a pair of integers; √-1 is i. Such roots are independent, so a
// number is zero only if the map is empty.
const gcd = (a, b) => { while (b) [a, b] = [b, a % b]; return a < 0n ? -a : a; };
const reduced = ([top, bottom]) => {
  const common = gcd(top, bottom) * (bottom < 0n ? -1n : 1n);
  return [top / common, bottom / common];
};
const rational = (top, bottom = 1n) => new Map(top ? [[1n, reduced([top, bottom])]] : []);
const sum = (a, b) => {
  const found = new Map(a);
  for (const [below, [top, bottom]] of b) {
    const [p, q] = found.get(below) ?? [0n, 1n];
    const value = reduced([p * bottom + top * q, q * bottom]);
    if (value[0]) found.set(below, value); else found.delete(below);
  }
  return found;
};
const size = n => n < 0n ? -n : n;
const product = (a, b) => {
  let found = new Map();
  for (const [m, [p, q]] of a) for (const [n, [r, s]] of b) {
    const common = gcd(size(m), size(n)), sign = m < 0n && n < 0n ? -1n : 1n;
    const below = size(m) / common * (size(n) / common) * ((m < 0n) !== (n < 0n) ? -1n : 1n);
    found = sum(found, new Map([[below, reduced([sign * common * p * r, q * s])]]));
  }
  return found;
};
const minus = (a, b) => sum(a, product(b, rational(-1n)));
const conjugate = a => new Map([...a].map(([m, [p, q]]) => [m, m < 0n ? [-p, q] : [p, q]]));
const primeIn = n => { for (let p = 2n; p * p <= n; p++) if (n % p === 0n) return p; return n; };
const inverse = a => {
  if (!a.size) throw new RangeError("zero");
  const root = [...a.keys()].find(m => m !== 1n);
  if (root === undefined) { const [p, q] = a.get(1n); return rational(q, p); }
  const prime = root < 0n ? 0n : primeIn(root);
  const turns = m => prime ? m % prime === 0n : m < 0n;
  const other = new Map([...a].map(([m, [p, q]]) => [m, turns(m) ? [-p, q] : [p, q]]));
  return product(other, inverse(product(a, other)));
};
const power = (a, n) => { let found = rational(1n); while (n--) found = product(found, a); return found; };
const rootOf = a => {  // of a rational number that is not negative, nor too long to be factored
  const [p, q] = a?.get(1n) ?? [0n, 1n];
  if (a && a.size === (p ? 1 : 0) && p >= 0n && p * q < 10n ** 12n) return typed(`1/${q}√${p * q}`);
};
const isReal = a => [...a.keys()].every(m => m > 0n);
const floorRoot = n => {
  let x = 1n << BigInt((n.toString(2).length >> 1) + 1);
  for (;;) { const y = (x + n / x) >> 1n; if (y >= x) return x; x = y; }
};
const isNegative = a => {  // of a real number: digits until the sign is clear
  if (!a.size) return false;
  for (let scale = 10n ** 20n; ; scale *= scale) {
    let low = 0n, high = 0n;
    for (const [m, [p, q]] of a) {
      const root = floorRoot(m * scale * scale), ends = [root * p, (root + 1n) * p];
      if (p < 0n) ends.reverse();
      low += ends[0] * scale / q - 1n; high += ends[1] * scale / q + 1n;
    }
    if (low > 0n) return false;
    if (high < 0n) return true;
  }
};
const typed = text => {  // "3/2 - 1/9 √51 i"; undefined if it is no number
  const rest = text.replace(/[\s*·]/g, "").replace(/[−–]/g, "-").replace(/sqrt\(?(\d+)\)?/g, "√$1");
  if (!/^([+-]?(?=[\d√i])(\d+([/.]\d+)?)?(√\d+)?i?(\/\d+)?)([+-](?=[\d√i])(\d+([/.]\d+)?)?(√\d+)?i?(\/\d+)?)*$/.test(rest)) return;
  let found = new Map();
  for (const [, sign, many, root, unit, below] of
      rest.matchAll(/([+-]?)(\d+(?:[/.]\d+)?)?(√\d+)?(i)?(?:\/(\d+))?/g)) {
    if (!many && !root && !unit) continue;
    const [whole, part] = (many ?? "1").split(/[/.]/);
    const decimal = many?.includes(".");
    const top = BigInt(decimal ? whole + part : whole);
    const bottom = (decimal ? 10n ** BigInt(part.length) : BigInt(part ?? 1)) * BigInt(below ?? 1);
    if (!bottom) return;
    let inside = BigInt(root?.slice(1) ?? 1), outside = inside ? 1n : 0n;
    for (let p = 2n; p * p <= inside; p++) while (inside % (p * p) === 0n) { inside /= p * p; outside *= p; }
    const term = rational((sign === "-" ? -top : top) * outside, bottom);
    found = sum(found, product(term, new Map([[(inside || 1n) * (unit ? -1n : 1n), [1n, 1n]]])));
  }
  return found;
};
const shown = a => [...a].map(([m, [p, q]], k) => {
  const behind = (size(m) > 1n ? `√${size(m)}` : "") + (m < 0n ? "i" : "");
  const many = size(p) === 1n && q === 1n && behind ? "" : `${size(p)}${q > 1n ? `/${q}` : ""}`;
  return `${p < 0n ? (k ? " − " : "−") : k ? " + " : ""}${many}${q > 1n && behind ? " " : ""}${behind}`;
}).join("") || "0";

// What a version of a statement says at a point: the tests that fail, else the two sides.
const HOLDS = {
  equal: (a, b) => !minus(a, b).size,
  conjugate: (a, b) => !minus(conjugate(a), b).size,
  nonzero: a => a.size > 0,
  positive: a => isReal(a) && !isNegative(a),
};
const evaluated = (version, values) => {
  const known = [];
  const step = ([what, ...args]) => {  // undefined where something is divided by zero
    if (what === "number") { const [p, q] = args[0].split("/"); return rational(BigInt(p), BigInt(q ?? 1)); }
    if (what === "value") return values[args[0]];
    const own = (what === "power" ? args.slice(0, 1) : args).map(k => known[k]);
    if (own.includes(undefined)) return;
    if (what === "power") return power(own[0], args[1]);
    if (what === "inverse") return own[0].size ? inverse(own[0]) : undefined;
    return what === "sum" ? sum(...own) : product(...own);
  };
  for (const one of version.steps) known.push(step(one));
  return known;
};
const judge = (version, values) => {
  const known = evaluated(version, values);
  const fails = ([kind, ...args]) => {
    const own = args.map(k => known[k]);
    return own.includes(undefined) || !HOLDS[kind](...own);
  };
  const broken = version.tests.flatMap((test, k) => fails(test) ? [k] : []);
  const sides = version.sides.map(pair => pair.map(k => known[k]));
  if (broken.length || sides.flat().includes(undefined)) return { broken };
  const differing = sides.find(pair => minus(...pair).size);
  return { broken, sides: differing ?? sides[0], differ: Boolean(differing) };
};

for (const form of document.querySelectorAll("form.trial")) {
  const parts = [...form.querySelectorAll("fieldset")];
  const versions = parts.map(part => JSON.parse(part.dataset.steps));
  const boxes = part => [...part.querySelectorAll("input")];
  const read = (k, name) => typed(boxes(parts[k]).find(box => box.name === name)?.value ?? versions[k].values[name]);
  const choices = [...form.querySelectorAll("input[type=radio]")];
  let at = 0;
  const reset = k => { for (const box of boxes(parts[k])) box.value = versions[k].values[box.name].replaceAll("-", "−"); };
  const values = k => Object.fromEntries(Object.keys(versions[k].values).map(name => [name, read(k, name)]));
  const update = () => {
    const own = values(at), part = parts[at];
    const unread = Object.values(own).includes(undefined);
    for (const box of boxes(part)) box.setAttribute("aria-invalid", String(own[box.name] === undefined));
    const said = unread ? undefined : judge(versions[at], own);
    part.querySelectorAll(".broken li").forEach((one, k) => { one.hidden = !said?.broken.includes(k); });
    part.querySelector(".broken").hidden = !said?.broken.length;
    const verdict = part.querySelector("output");
    verdict.className = said?.sides ? (said.differ ? "refuted" : "proved") : "";
    verdict.textContent = unread ? "Type numbers such as −3/2, 1+2i, 1/9√51." : !said.sides ? (said.broken.length ? "" : "Not defined at this point.") :
      `left side ${shown(said.sides[0])}, right side ${shown(said.sides[1])}: ` +
      (said.differ ? "they differ." : "equal at this point.");
  };
  const put = (name, value) => {
    const box = boxes(parts[at]).find(one => one.name === name);
    if (box) box.value = shown(value).replaceAll(" ", "");
  };
  const change = k => {  // to another version, at the same point if it is one there
    const before = at;
    parts.forEach((part, one) => { part.hidden = one !== k; });
    at = k;
    if (before === k) return update();
    reset(k);
    for (const box of boxes(parts[k])) {
      const same = boxes(parts[before]).find(one => one.name === box.name);
      if (same) box.value = same.value;
    }
    const own = values(k);
    if (!Object.values(own).includes(undefined) && judge(versions[k], own).broken.length) reset(k);
    update();
  };
  form.addEventListener("input", ({ target }) => {
    if (target.type === "radio") return change(choices.indexOf(target));
    const pair = versions[at].pairs.find(one => one.includes(target.name));
    const value = typed(target.value ?? "");
    if (pair && value) {  // the conjugate follows
      put(pair[pair[0] === target.name ? 1 : 0], conjugate(value));
    }
    if (target.name) for (const [name, square] of versions[at].roots) {  // and so do roots
      const root = rootOf(evaluated(versions[at], values(at))[square]);
      if (root) put(name, root);
    }
    update();
  });
  form.addEventListener("submit", event => event.preventDefault());
  form.querySelector("button").addEventListener("click", () => { reset(at); update(); });
  parts.forEach((part, k) => {
    for (const box of boxes(part)) box.closest("label").hidden = versions[k].roots.some(([name]) => name === box.name);
  });
  reset(0); change(0);
  form.hidden = false;
}
