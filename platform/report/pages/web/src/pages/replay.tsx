import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { useLoaded } from '../data/use';
import { savePng } from '../kit/download';
import { Moment } from '../kit/moment';
import { isTaken } from '../kit/keys';
import { choose } from '../kit/route';
import { Stage } from '../robot/stage';
import { Empty, Key, Select, Show } from '../ui/parts';
import { TrialCurvesPanel } from '../ui/trial_curves';
import { loadPieces, loadPlay, whyNothing, type Piece, type Play } from './replay_data';

/** Robots in motion, target and model over each other. */
export function ReplayPage({ choices }: { choices: Record<string, string> }) {
  const pieces = useLoaded(loadPieces, ['pieces']);
  return <Show of={pieces}>{(all) => (all.length === 0 ? <Nothing /> : <Pieces all={all} choices={choices} />)}</Show>;
}

function Nothing() {
  const why = useLoaded(whyNothing, ['why nothing']);
  return <Show of={why}>{(sentences) => <Empty>{sentences}</Empty>}</Show>;
}

/** What is asked for, else what was shown last, else the newest. */
function useChosen(all: Piece[], choices: Record<string, string>): Piece | undefined {
  const last = useRef('');
  const { piece, run, trial } = choices;
  const wanted = piece ?? (run !== undefined && trial !== undefined ? `run ${run}/${trial}` : undefined);
  const chosen =
    wanted !== undefined
      ? all.find((one) => one.key === wanted)
      : run !== undefined
        ? all.find((one) => String(one.run) === run)
        : (all.find((one) => one.key + one.identity === last.current) ?? all[0]);
  last.current = chosen ? chosen.key + chosen.identity : '';
  return chosen;
}

function Pieces({ all, choices }: { all: Piece[]; choices: Record<string, string> }) {
  const piece = useChosen(all, choices);
  const options = all.map((one) => ({ value: one.key, label: one.label }));
  const asked = choices.piece ?? `run ${choices.run}${choices.trial === undefined ? '' : `, trial ${choices.trial}`}`;
  return (
    <>
      <div class="choices">
        <Select
          label="Trial"
          value={piece?.key ?? ''}
          options={piece ? options : [{ value: '', label: '—' }, ...options]}
          change={(value) => choose({ piece: value, run: null, trial: null, t: null })}
        />
      </div>
      {piece ? (
        <Player key={piece.identity + piece.key} piece={piece} start={Number(choices.t ?? 0)} />
      ) : (
        <Empty>No motion is stored for {asked}. Choose another trial from the list.</Empty>
      )}
    </>
  );
}

function Player({ piece, start }: { piece: Piece; start: number }) {
  // Loaded once: a run that goes on writing must not stop what plays. What could not be loaded is tried again.
  const [load] = useState(() => ({ done: null as Promise<Play> | null }));
  const play = useLoaded(
    (source) => {
      load.done ??= loadPlay(source, piece).catch((error: unknown) => {
        load.done = null;
        throw error;
      });
      return load.done;
    },
    ['play', piece.identity, piece.key],
  );
  return <Show of={play}>{(value) => <Playing play={value} title={piece.label} start={start} />}</Show>;
}

const kSpeeds = ['0.05', '0.1', '0.25', '0.5', '1', '2', '4'];

function Playing({ play, title, start }: { play: Play; title: string; start: number }) {
  const { times } = play.curves;
  const [first, last] = [times[0], times[times.length - 1]];
  const moment = useMemo(() => new Moment(), []);
  const [playing, setPlaying] = useState(false);
  const [speed, setSpeed] = useState('1');
  const go = (time: number) => moment.set(Math.min(Math.max(time, first), last));
  useEffect(() => go(start || first), []);
  // At once with the button's label, so that no frame comes after a pause.
  useLayoutEffect(() => {
    if (!playing) return;
    let before = performance.now(),
      frame = 0;
    const step = (now: number) => {
      const next = moment.time + ((now - before) / 1000) * Number(speed);
      before = now;
      go(next >= last ? first : next);
      frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
    return () => cancelAnimationFrame(frame);
  }, [playing, speed]);
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (isTaken(event)) return;
      const stride = ((last - first) / 200) * (event.shiftKey ? 10 : 1);
      const actions: Record<string, () => void> = {
        ' ': () => setPlaying((one) => !one),
        ArrowLeft: () => go(moment.time - stride),
        ArrowRight: () => go(moment.time + stride),
        Home: () => go(first),
        End: () => go(last),
        ',': () => setSpeed((one) => kSpeeds[Math.max(kSpeeds.indexOf(one) - 1, 0)]),
        '.': () => setSpeed((one) => kSpeeds[Math.min(kSpeeds.indexOf(one) + 1, kSpeeds.length - 1)]),
      };
      if (!actions[event.key]) return;
      actions[event.key]();
      event.preventDefault();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  }, []);
  const stage = useRef<Stage | null>(null);
  return (
    <>
      {play.actors.length > 0 ? <StageView play={play} moment={moment} stage={stage} /> : null}
      <div class="player">
        <button class="primary" onClick={() => setPlaying(!playing)} aria-label={playing ? 'Pause' : 'Play'}>
          {playing ? '❚❚' : '▶'}
        </button>
        <Scrubber moment={moment} first={first} last={last} go={go} />
        <Select
          label="speed"
          value={speed}
          options={kSpeeds.map((one) => ({ value: one, label: `${one} ×` }))}
          change={setSpeed}
        />
        {play.actors.length > 0 && (
          <button
            class="quiet download"
            onClick={() => stage.current && savePng([stage.current.canvas], `replay ${title}`)}
          >
            PNG
          </button>
        )}
        <button
          class="quiet download"
          title="Put this time into the page's address"
          onClick={() => choose({ t: moment.time.toFixed(3) })}
        >
          link
        </button>
      </div>
      <p class="note">
        {play.note} {play.actors.some((one) => one.touching) && 'Bodies that touch the ground are highlighted. '}
        <span class="keys">
          Keys: <Key>space</Key> play, <Key>←</Key> / <Key>→</Key> step, <Key>,</Key> (comma) slower, <Key>.</Key> (full
          stop) faster. Drag to turn the camera.
        </span>
      </p>
      <TrialCurvesPanel
        curves={play.curves}
        title={title}
        lit={kNothing}
        moment={moment}
        go={go}
        keep={() =>
          savePng([...document.querySelectorAll<HTMLCanvasElement>('.trial-curves canvas')], `replay ${title}`)
        }
      />
    </>
  );
}

const kNothing: [number, number][] = [];

function Scrubber({
  moment,
  first,
  last,
  go,
}: {
  moment: Moment;
  first: number;
  last: number;
  go: (time: number) => void;
}) {
  const slider = useRef<HTMLInputElement>(null),
    text = useRef<HTMLSpanElement>(null);
  useEffect(() => {
    const show = () => {
      slider.current!.value = String(moment.time);
      text.current!.textContent = `${moment.time.toFixed(2)} s`;
    };
    show();
    return moment.listen(show);
  }, [moment]);
  return (
    <>
      <input
        ref={slider}
        type="range"
        min={first}
        max={last}
        step={(last - first) / 2000}
        aria-label="Time"
        onInput={(event) => go(Number(event.currentTarget.value))}
      />
      <span class="clock" ref={text} />
    </>
  );
}

function StageView({ play, moment, stage }: { play: Play; moment: Moment; stage: { current: Stage | null } }) {
  const box = useRef<HTMLDivElement>(null);
  const [error, setError] = useState<string | null>(null);
  useEffect(() => {
    let made: Stage;
    try {
      made = new Stage(box.current!, play.actors);
    } catch {
      setError('This browser has no WebGL, so it cannot show the robot. The curves below are complete.');
      return;
    }
    stage.current = made;
    const sizes = new ResizeObserver(() => made.resize());
    sizes.observe(box.current!);
    const paint = () => made.paint();
    addEventListener('lacuna-theme', paint);
    const stop = moment.listen(() => made.show(moment.time));
    made.show(moment.time);
    return () => {
      stop();
      sizes.disconnect();
      removeEventListener('lacuna-theme', paint);
      made.dispose();
      stage.current = null;
    };
  }, [play, moment]);
  return (
    <>
      {error && <p class="error">{error}</p>}
      <div class={error ? '' : 'stage'} ref={box}>
        {!error && (
          <div class="legend over">
            <span class="key swatch-model">
              <i />
              model (predicted)
            </span>
            {play.actors.length > 1 && (
              <span class="key swatch-target">
                <i />
                target (measured)
              </span>
            )}
          </div>
        )}
      </div>
    </>
  );
}
