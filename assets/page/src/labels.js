// Labels over a picture that do not lie over one another.

/** Px between a label and its place. */
const GAP = 7;

/** Corners of a label's box, relative to its place, in the order in which they are tried. */
const SIDES = [
  (w, h) => [GAP, -h - 2],
  (w, h) => [-w - GAP, -h - 2],
  () => [GAP, 3],
  (w) => [-w - GAP, 3],
  (w, h) => [-w / 2, -h - GAP],
  (w) => [-w / 2, GAP],
];

/** Those of a number at the tick of a scale: beside it, or below. */
const TICK = [(w, h) => [-w - 3, -h / 2], (w) => [-w / 2, 3], (w, h) => [GAP, -h - 2]];

const meet = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

/** Puts every label beside its place, in their order, and hides those for which there is no room. */
export function arrange(texts, project, place) {
  const [width, height] = [place.clientWidth, place.clientHeight];
  const taken = [];
  for (const entry of texts) {
    const { text, at } = entry;
    const sides = text.className === "tick" ? TICK : SIDES;
    const p = project(at);
    if (entry.size === undefined || entry.size[0] === 0) {
      text.hidden = false;
      entry.size = [text.offsetWidth, text.offsetHeight];
    }
    const [w, h] = entry.size;
    const boxes = sides.map((side) => side(w, h)).map(([x, y]) => [p.x + x, p.y + y, p.x + x + w, p.y + y + h]);
    const fits = ([left, top, right, bottom]) => left >= 0 && top >= 0 && right <= width && bottom <= height;
    const box = p.z > 1 ? undefined : boxes.find((b) => fits(b) && !taken.some((other) => meet(b, other)));
    text.hidden = box === undefined;
    if (!box) continue;
    taken.push(box);
    // In shares of the place, so that labels stay in position if the picture is stretched.
    text.style.left = `${(100 * box[0]) / width}%`;
    text.style.top = `${(100 * box[1]) / height}%`;
  }
}
