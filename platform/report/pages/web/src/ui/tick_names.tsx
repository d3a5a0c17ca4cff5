import { labelLines } from '../kit/labels';

const kLetter = 6; // px
const kLine = 11; // px
const kLetters = 16; // of a line
const kMostLines = 3;

/** Names below ticks in lines; what is longer still keeps what tells it from the others. */
export const nameLines = (names: string[]): string[][] => labelLines(names, kLetters, kMostLines);

export interface NameRoom {
  /** Degrees that names are turned by. */
  turn: number;
  room: number; // px
}

/** Names below the ticks stand aslant where they would not fit beside each other, the steeper the closer the ticks are,
 *  and need room for that. */
export function roomForNames(names: string[] | undefined, width: number): NameRoom {
  if (names === undefined) return { turn: 0, room: 0 };
  const lines = nameLines(names);
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
  lines: string[];
  x: number;
  y: number;
  turn: number;
}

/** A name or number below a tick; a long one is whole where the pointer rests on it. */
export function TickName({ name, lines, x, y, turn }: Props) {
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
