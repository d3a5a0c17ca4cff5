// Canvases as one picture that says what it shows: with the title, the legend and the database that the page has.

interface Key {
  text: string;
  colour: string;
  dashed: boolean;
  /** A patch, not a line. */
  filled: boolean;
}

interface Heading {
  title: string[];
  keys: Key[];
  source: string;
}

const kMargin = 10; // px of the page, as all here
const kLine = 18;
const kMostLines = 3;
const kTitleFont = '600 14px system-ui, sans-serif';
const kTextFont = '12px system-ui, sans-serif';

function keysOf(legend: Element | null): Key[] {
  return [...(legend?.querySelectorAll('.key') ?? [])].map((key) => {
    const mark = getComputedStyle(key.querySelector('i')!);
    const filled = parseFloat(mark.borderTopWidth) === 0;
    return {
      text: key.textContent ?? '',
      colour: filled ? mark.backgroundColor : mark.borderTopColor,
      dashed: mark.borderTopStyle === 'dashed',
      filled,
    };
  });
}

const sourceText = () => [...document.querySelectorAll('footer span')].map((one) => one.textContent).join(' · ');

/** Broken where a line is full; what does not fit into a few lines is left out. */
function broken(pen: CanvasRenderingContext2D, text: string, width: number): string[] {
  const lines: string[] = [''];
  for (const letter of text.slice(0, 1000)) {
    if (pen.measureText(lines[lines.length - 1] + letter).width > width) lines.push('');
    lines[lines.length - 1] += letter;
  }
  if (lines.length <= kMostLines) return lines;
  return [...lines.slice(0, kMostLines - 1), `${lines[kMostLines - 1].slice(0, -1)}…`];
}

function drawKey(pen: CanvasRenderingContext2D, key: Key, x: number, middle: number): void {
  pen.fillStyle = pen.strokeStyle = key.colour;
  pen.lineWidth = 2;
  pen.setLineDash(key.dashed ? [4, 3] : []);
  if (key.filled) {
    pen.fillRect(x, middle - 5, 16, 10);
  } else {
    pen.beginPath();
    pen.moveTo(x, middle);
    pen.lineTo(x + 16, middle);
    pen.stroke();
  }
}

/** Keys beside each other, then in further lines. Returns where the last line ends; draws where `ink` is given. */
function legend(pen: CanvasRenderingContext2D, keys: Key[], top: number, width: number, ink: string | null): number {
  let [x, y] = [kMargin, top];
  for (const key of keys) {
    const wide = 22 + pen.measureText(key.text).width + 14;
    if (x > kMargin && x + wide > width) [x, y] = [kMargin, y + kLine];
    if (ink !== null) {
      drawKey(pen, key, x, y + kLine / 2);
      pen.fillStyle = ink;
      pen.fillText(key.text, x + 22, y + kLine / 2);
    }
    x += wide;
  }
  return keys.length > 0 ? y + kLine : top;
}

/** Returns its height; draws where `ink` is given. */
function drawHeading(pen: CanvasRenderingContext2D, of: Heading, width: number, ink: string | null): number {
  let y = kMargin;
  pen.textBaseline = 'middle';
  pen.font = kTitleFont;
  if (ink !== null) {
    pen.fillStyle = ink;
    of.title.forEach((line, i) => pen.fillText(line, kMargin, y + (i + 0.5) * kLine));
  }
  y += of.title.length * kLine;
  pen.font = kTextFont;
  if (ink !== null) pen.fillText(of.source, kMargin, y + kLine / 2, width - 2 * kMargin);
  return legend(pen, of.keys, y + kLine, width, ink) + kMargin;
}

/** Canvases one below the other, on the page's own ground, under what the page says about them. */
export function sheetOf(canvases: HTMLCanvasElement[], title: string): HTMLCanvasElement {
  const sheet = document.createElement('canvas');
  const pen = sheet.getContext('2d')!;
  const width = Math.max(...canvases.map((one) => one.width));
  const scale = canvases[0].width / (canvases[0].clientWidth || canvases[0].width);
  pen.font = kTitleFont;
  const heading: Heading = {
    title: broken(pen, title, width / scale - 2 * kMargin),
    keys: keysOf(canvases[0].closest('figure, .stage')?.querySelector('.legend') ?? null),
    source: sourceText(),
  };
  const top = Math.ceil(scale * drawHeading(pen, heading, width / scale, null));
  sheet.width = width;
  sheet.height = canvases.reduce((sum, one) => sum + one.height, top);
  const style = getComputedStyle(document.body);
  pen.fillStyle = style.backgroundColor;
  pen.fillRect(0, 0, sheet.width, sheet.height);
  pen.scale(scale, scale);
  drawHeading(pen, heading, width / scale, style.color);
  pen.resetTransform();
  let y = top;
  for (const one of canvases) {
    pen.drawImage(one, 0, y);
    y += one.height;
  }
  return sheet;
}
