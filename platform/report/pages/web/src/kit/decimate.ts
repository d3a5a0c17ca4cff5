/** Smallest and largest value of each block of samples; NaN where a block has none. */
interface Level {
  block: number;
  least: Float64Array;
  most: Float64Array;
}

const kBlocks = [32, 1024];

/** A series that can be drawn at any zoom in a time that does not depend on its length. */
export class Series {
  private readonly levels: Level[];

  constructor(readonly values: Float64Array) {
    this.levels = kBlocks.filter((block) => values.length > 4 * block).map((block) => level(values, block));
  }

  /** Smallest and largest value of samples `from` to `to`, the end not included. */
  extremes(from: number, to: number): [number, number] {
    let least = Infinity,
      most = -Infinity;
    const take = (low: number, high: number) => {
      if (low < least) least = low;
      if (high > most) most = high;
    };
    for (let at = from; at < to;) {
      const step = this.levels.findLast((one) => at % one.block === 0 && at + one.block <= to);
      if (step) take(step.least[at / step.block], step.most[at / step.block]);
      else take(this.values[at], this.values[at]);
      at += step ? step.block : 1;
    }
    return least <= most ? [least, most] : [NaN, NaN];
  }
}

function level(values: Float64Array, block: number): Level {
  const count = Math.floor(values.length / block);
  const least = new Float64Array(count),
    most = new Float64Array(count);
  for (let b = 0; b < count; ++b) {
    let low = Infinity,
      high = -Infinity;
    for (let i = b * block; i < (b + 1) * block; ++i) {
      if (values[i] < low) low = values[i];
      if (values[i] > high) high = values[i];
    }
    least[b] = low <= high ? low : NaN;
    most[b] = low <= high ? high : NaN;
  }
  return { block, least, most };
}

/** The first sample that is not before `time`. */
export function sampleAt(times: Float64Array, time: number): number {
  let low = 0,
    high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** What to draw of series on common times between `from` and `to`: every sample where there are few, else the extremes
 *  of about `columns` stretches. The first array is times. */
export function drawn(
  times: Float64Array,
  series: Series[],
  from: number,
  to: number,
  columns: number,
): Float64Array[] {
  const first = Math.max(sampleAt(times, from) - 1, 0);
  const end = Math.min(sampleAt(times, to) + 2, times.length);
  if (end - first <= 3 * columns)
    return [times.slice(first, end), ...series.map((one) => one.values.slice(first, end))];
  let stride = Math.ceil((end - first) / columns);
  if (stride > kBlocks[0]) stride = Math.ceil(stride / kBlocks[0]) * kBlocks[0];
  const begin = Math.floor(first / stride) * stride;
  const count = Math.ceil((end - begin) / stride);
  const out = [times, ...series].map(() => new Float64Array(2 * count));
  for (let c = 0; c < count; ++c) {
    const low = begin + c * stride,
      high = Math.min(low + stride, times.length);
    out[0][2 * c] = times[low];
    out[0][2 * c + 1] = times[(low + high) >> 1];
    series.forEach((one, s) => {
      [out[s + 1][2 * c], out[s + 1][2 * c + 1]] = one.extremes(low, high);
    });
  }
  return out;
}
