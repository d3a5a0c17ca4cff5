const kLetter = 6; // px
const kLine = 11; // px
const kLetters = 14; // of a line
const kMostLines = 3;

/** A long name in lines that end behind "_", "." or "·"; what is longer still is cut. */
export function linesOf(name: string): string[] {
  const lines: string[] = [];
  for (const part of name.match(/[^_.· ]*[_.· ]*/g) ?? []) {
    const last = lines[lines.length - 1];
    if (last !== undefined && (last + part).trimEnd().length <= kLetters) lines[lines.length - 1] = last + part;
    else if (part !== '') lines.push(part);
  }
  const cut = lines.map((one) => (one.length > kLetters + 3 ? `${one.slice(0, kLetters + 2)}…` : one));
  return cut.length > kMostLines ? [...cut.slice(0, kMostLines), '…'] : cut;
}

export interface NameRoom {
  /** Degrees that names are turned by. */
  turn: number;
  room: number; // px
}

/** Names below the ticks stand aslant where they would not fit beside each other, the steeper the closer the ticks are,
 *  and need room for that. */
export function roomForNames(names: string[] | undefined, width: number): NameRoom {
  if (names === undefined) return { turn: 0, room: 0 };
  const lines = names.map(linesOf);
  const longest = kLetter * Math.max(0, ...lines.flat().map((one) => one.length));
  const thick = kLine * Math.max(1, ...lines.map((one) => one.length));
  const apart = width / names.length;
  if (longest <= apart) return { turn: 0, room: thick - kLine };
  const turn = [40, 60].find((one) => thick <= apart * sine(one)) ?? 80;
  return { turn, room: longest * sine(turn) + thick * sine(90 - turn) - kLine };
}

const sine = (degrees: number) => Math.sin((degrees * Math.PI) / 180);

interface Props {
  name: string;
  x: number;
  y: number;
  turn: number;
}

/** A name or number below a tick; a long one is whole where the pointer rests on it. */
export function TickName({ name, x, y, turn }: Props) {
  const lines = linesOf(name);
  return (
    <text text-anchor={turn ? 'end' : 'middle'} transform={`translate(${x} ${y}) rotate(${-turn})`}>
      {lines[0] !== name && <title>{name}</title>}
      {lines.map((line, i) => (
        <tspan key={i} x="0" dy={i === 0 ? 0 : kLine}>
          {line}
        </tspan>
      ))}
    </text>
  );
}
