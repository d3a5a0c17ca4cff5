import { cellText } from './format';
import { sheetOf } from './sheet';

/** A file name that every system takes. */
export const fileName = (title: string) =>
  title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '')
    .slice(0, 80) || 'lacuna';

export function save(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

const kStyles = [
  'fill',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'stroke-opacity',
  'fill-opacity',
  'opacity',
  'font-size',
  'font-family',
  'font-weight',
  'text-anchor',
  'dominant-baseline',
];

/** The picture with its colours written into it, as a file of its own. */
export function svgText(picture: SVGSVGElement): string {
  const copy = picture.cloneNode(true) as SVGSVGElement;
  const from = picture.querySelectorAll('*'),
    to = copy.querySelectorAll('*');
  from.forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const name of kStyles) to[i].setAttribute(name, style.getPropertyValue(name));
    to[i].removeAttribute('class');
  });
  const ground = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
  ground.setAttribute('width', '100%');
  ground.setAttribute('height', '100%');
  ground.setAttribute('fill', getComputedStyle(document.body).backgroundColor);
  copy.prepend(ground);
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return new XMLSerializer().serializeToString(copy);
}

export const saveSvg = (picture: SVGSVGElement, title: string) =>
  save(`${fileName(title)}.svg`, new Blob([svgText(picture)], { type: 'image/svg+xml' }));

/** Canvases that stand in one figure, with its legend. */
export const savePng = (canvases: HTMLCanvasElement[], title: string) =>
  sheetOf(canvases, title).toBlob((blob) => blob && save(`${fileName(title)}.png`, blob), 'image/png');

const csvCell = (cell: unknown) => {
  const text = typeof cell === 'object' ? cellText(cell) : String(cell ?? '');
  return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
};

/** RFC 4180, every digit. */
export const csvText = (columns: string[], rows: unknown[][]) =>
  [columns, ...rows].map((row) => row.map(csvCell).join(',')).join('\r\n') + '\r\n';

export const saveCsv = (columns: string[], rows: unknown[][], title: string) =>
  save(`${fileName(title)}.csv`, new Blob([csvText(columns, rows)], { type: 'text/csv' }));
