import type { Finding, Score } from './compare_data';

/** Where to look: a trial, a channel of it and a stretch of time; null where all of them are meant. */
export interface Place {
  trial: string | null;
  channel: string | null;
  from: number | null; // s
  to: number | null;
}

const kNowhere: Place = { trial: null, channel: null, from: null, to: null };

/** Squared error in floors: how much of a comparison's error a score stands for. */
const weight = (score: Score) => (score.times_floor ?? score.normalised_rmse ?? 0) ** 2;

const best = <One>(all: One[], worth: (one: One) => number) =>
  all.reduce<One | null>((a, b) => (a === null || worth(b) > worth(a) ? b : a), null);

const worthOf = (trial: string, scores: Score[]) =>
  scores.filter((one) => one.trial === trial).reduce((sum, one) => sum + weight(one), 0);

const lengthOf = (spans: [number, number][]) => spans.reduce((sum, [from, to]) => sum + to - from, 0);

/** The trial in which most of what a finding speaks of lies: of its stretches the longest, weighed by the trial's error;
 *  of one without stretches the trial that is farthest off in its channel. */
function trialOf(finding: Finding, scores: Score[]): string | null {
  const known = (trial: string) => scores.some((one) => one.trial === trial);
  if (finding.trial !== undefined && known(finding.trial)) return finding.trial;
  const stretches = (finding.stretches ?? []).filter((one) => known(one.trial));
  if (stretches.length > 0)
    return best(stretches, (one) => lengthOf(one.spans) * Math.max(worthOf(one.trial, scores), 1e-9))!.trial;
  const own = scores.filter((one) => !one.held_out && one.channel === finding.channel);
  const all = own.length > 0 ? own : scores.filter((one) => !one.held_out);
  return best(all, weight)?.trial ?? null;
}

/** The channel that a finding names, else the one that is farthest off in the trial. */
function channelOf(finding: Finding, own: Score[]): string | null {
  if (own.some((one) => one.channel === finding.channel)) return finding.channel!;
  return best(own, weight)?.channel ?? null;
}

/** `chosen`: the trial that is looked at, where one is chosen; else the finding's own. */
export function placeOf(finding: Finding, scores: Score[], chosen?: string): Place {
  const trial = chosen ?? trialOf(finding, scores);
  if (trial === null) return kNowhere;
  const own = scores.filter((one) => one.trial === trial);
  const spans = finding.stretches?.find((one) => one.trial === trial)?.spans ?? [];
  return {
    trial,
    channel: channelOf(finding, own),
    from: spans.length > 0 ? Math.min(...spans.map(([from]) => from)) : null,
    to: spans.length > 0 ? Math.max(...spans.map(([, to]) => to)) : null,
  };
}

const kAround = 0.05; // of a trial, on each side of a moment

/** What an address chooses comes before what a finding tells: "?channel=angle&t=1.5" or "&t=1.5-2.5". */
export function chosenPlace(choices: Record<string, string>, of: Place | null): Place {
  const times = /^(-?[\d.]+(?:e-?\d+)?)(?:-([\d.]+))?$/.exec(choices.t ?? '');
  const place = of ?? kNowhere;
  return {
    trial: choices.trial ?? place.trial,
    channel: choices.channel ?? place.channel,
    from: times ? Number(times[1]) : place.from,
    to: times ? Number(times[2] ?? times[1]) : place.to,
  };
}

/** What of a trial from `first` to `last` to show at first: a little more than the stretch, all where it is most of it. */
export function stretchToShow(place: Place, first: number, last: number): [number, number] {
  const { from, to } = place;
  if (from === null || to === null || !Number.isFinite(from) || !Number.isFinite(to)) return [first, last];
  const room = Math.max(0.2 * (to - from), kAround * (last - first));
  return [Math.max(from - room, first), Math.min(to + room, last)];
}
