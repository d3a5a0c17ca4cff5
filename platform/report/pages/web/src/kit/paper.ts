/** Between the margins of a sheet of A4 or letter that stands upright, px. */
export const kPaperWidth = 700;

/** Calls `before` and `after` around each time that the page is printed. Returns what ends it. */
export function whenPrinted(before: () => void, after: () => void): () => void {
  addEventListener('beforeprint', before);
  addEventListener('afterprint', after);
  return () => {
    removeEventListener('beforeprint', before);
    removeEventListener('afterprint', after);
  };
}

/** As narrow as its words allow, and no narrower than paper. */
function narrowest(table: HTMLElement): number {
  table.style.width = `${kPaperWidth}px`;
  const width = table.offsetWidth;
  table.style.width = '';
  return width;
}

/** Makes pictures and tables small enough for paper: no layout is told its width there. */
export function fitPaper(figure: HTMLElement): void {
  for (const picture of figure.querySelectorAll<SVGSVGElement>('.chart svg'))
    picture.setAttribute('viewBox', `0 0 ${picture.clientWidth} ${picture.clientHeight}`);
  const shrink = (part: HTMLElement, width: number) => {
    if (width > kPaperWidth) part.style.zoom = String(kPaperWidth / width);
  };
  for (const table of figure.querySelectorAll<HTMLElement>('table.grid')) shrink(table, narrowest(table));
  for (const table of figure.querySelectorAll<HTMLElement>('.data-table'))
    shrink(table, table.querySelector<HTMLElement>('.tabulator-table')?.offsetWidth ?? 0);
}

export function leavePaper(figure: HTMLElement): void {
  for (const picture of figure.querySelectorAll('.chart svg')) picture.removeAttribute('viewBox');
  for (const table of figure.querySelectorAll<HTMLElement>('table.grid, .data-table')) table.style.zoom = '';
}
