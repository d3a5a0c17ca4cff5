/** About `count` round numbers from `low` to `high`. */
export function linearTicks(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [low];
  const rough = (high - low) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= rough * 0.999) ?? rough;
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; ++i) ticks.push(i * step);
  return ticks;
}

const kNarrow = 4; // between the ends of an axis that has the ticks of a linear one
const kLinear = 8;
const kApart = 0.04;

/** Multiples of powers of ten, and how many powers apart: the more of an axis that is short, the fewer. */
const kSteps: { factors: number[]; powers: number; most: number }[] = [
  { factors: [1, 2, 3, 4, 5, 6, 7, 8, 9], powers: 1, most: 1.2 },
  { factors: [1, 2, 3, 5], powers: 1, most: 1.2 },
  { factors: [1, 2, 5], powers: 1, most: 3 },
  { factors: [1, 3], powers: 1, most: 3 },
  ...[1, 2, 3, 5, 10, 20, 50, 100, 200].map((powers) => ({ factors: [1], powers, most: Infinity })),
];

function multiples(low: number, high: number, { factors, powers }: { factors: number[]; powers: number }): number[] {
  const first = Math.floor(Math.floor(Math.log10(low)) / powers) * powers;
  const ticks: number[] = [];
  for (let power = first; power <= Math.ceil(Math.log10(high)); power += powers)
    for (const factor of factors) {
      const tick = Number(`${factor}e${power}`);
      if (tick >= low * 0.999 && tick <= high * 1.001) ticks.push(tick);
    }
  return ticks;
}

/** Powers of ten, with others between them where there are few; round numbers as of a linear axis where even these would
 *  leave much of it bare. `apart`: the least distance of two, as a share of the axis, that keeps their numbers apart. */
export function logTicks(low: number, high: number, apart = kApart): number[] {
  const length = Math.log(high) - Math.log(low);
  const areApart = (ticks: number[]) =>
    ticks.every((one, i) => i === 0 || Math.log(one / ticks[i - 1]) >= 0.999 * apart * length);
  if (high / low < kNarrow)
    for (let count = kLinear; count > 0; --count) {
      const ticks = linearTicks(low, high, count);
      if (areApart(ticks)) return ticks;
    }
  const decades = length / Math.LN10;
  const steps = kSteps.filter((one) => decades < one.most);
  return steps.map((one) => multiples(low, high, one)).find(areApart) ?? [];
}

/** Those of the ticks whose numbers, `width` px wide, do not touch; `first` wins against its neighbours. */
export function apartTicks(
  ticks: number[],
  place: (tick: number) => number,
  width: number,
  first = ticks[0],
): number[] {
  const kept: number[] = [];
  for (const tick of [first, ...ticks.filter((one) => one !== first)])
    if (ticks.includes(tick) && kept.every((other) => Math.abs(place(other) - place(tick)) >= width)) kept.push(tick);
  return kept.sort((a, b) => a - b);
}
