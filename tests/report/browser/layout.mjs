// What is wrong with the layout of a page: functions that a page evaluates.

/** What a phone does not show: wider than the page, and in no box of its own that scrolls sideways; a link to a page that
 *  is out of sight at first, or too small for a finger. */
export function whatIsCut() {
  const { clientWidth } = document.documentElement;
  const scrolls = (node) =>
    node && (/auto|scroll/.test(getComputedStyle(node).overflowX) || scrolls(node.parentElement));
  const found = [];
  if (document.documentElement.scrollWidth > clientWidth) found.push('the page scrolls sideways');
  for (const node of document.querySelectorAll('body *')) {
    const { left, right, width, height } = node.getBoundingClientRect();
    if (width === 0 || height === 0 || node.closest('.found, .tabulator-header, title, option')) continue; // a table's header follows it
    if ((right > clientWidth + 1 || left < -1) && !scrolls(node.parentElement))
      found.push(`${node.tagName} ${node.className.baseVal ?? node.className}: ${left} to ${right}`);
  }
  for (const link of document.querySelectorAll('nav a')) {
    const { left, right, height } = link.getBoundingClientRect();
    if (left < 0 || right > clientWidth || height < 30) found.push(`link ${link.textContent}: ${left} to ${right}`);
  }
  return found;
}

/** Controls that a finger does not reach: out of sight, or over another one. */
export function outOfReach() {
  const { clientWidth } = document.documentElement;
  const controls = [...document.querySelectorAll('main input, main select, main button, header button, header input')]
    .map((node) => ({ node, box: node.getBoundingClientRect() }))
    .filter(({ node, box }) => box.width > 0 && box.height > 0 && !node.closest('.tabulator'));
  const name = ({ node, box }) =>
    `${node.tagName} ${node.getAttribute('aria-label') ?? node.textContent.slice(0, 20)} at ${Math.round(box.left)} to ${Math.round(box.right)}`;
  const hidden = controls.filter(({ box }) => box.left < 0 || box.right > clientWidth + 1);
  const over = controls.filter((one, i) =>
    controls.some(({ node, box }, j) => {
      const [wide, high] = [
        Math.min(one.box.right, box.right) - Math.max(one.box.left, box.left),
        Math.min(one.box.bottom, box.bottom) - Math.max(one.box.top, box.top),
      ];
      const fixed = (of) => of.closest('header') !== null; // the page scrolls below it
      return j < i && wide > 1 && high > 1 && fixed(node) === fixed(one.node);
    }),
  );
  return [...hidden.map((one) => `out of sight: ${name(one)}`), ...over.map((one) => `over another: ${name(one)}`)];
}
