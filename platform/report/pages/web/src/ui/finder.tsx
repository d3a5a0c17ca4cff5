import { useContext, useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { SharedContext } from '../data/use';
import type { Source } from '../data/source';
import { linkTo } from '../kit/route';

interface Place {
  name: string;
  link: string;
}

const kMostFound = 12;

async function placesOf(source: Source): Promise<Place[]> {
  const places = async (sql: string, place: (row: (string | number)[]) => Place) =>
    (await source.query(sql)).rows.map((row) => place(row as (string | number)[]));
  const found = await Promise.all([
    places(
      'SELECT experiment, number, change FROM revisions ORDER BY experiment, number DESC',
      ([experiment, revision, change]) => ({
        name: `${experiment} · revision ${revision} · ${change}`,
        link: linkTo('compare', { experiment, revision }),
      }),
    ),
    places(
      'SELECT experiment, max(revision), trial FROM latest_comparison GROUP BY experiment, trial',
      ([experiment, revision, trial]) => ({
        name: `${experiment} · trial ${trial}`,
        link: linkTo('compare', { experiment, revision, trial }),
      }),
    ),
    places(
      'SELECT id, experiment, revision, verdict FROM diagnoses ORDER BY id DESC',
      ([diagnosis, experiment, revision, verdict]) => ({
        name: `${experiment} · revision ${revision} · ${String(verdict).replace(/_/g, ' ')}`,
        link: linkTo('diagnose', { diagnosis }),
      }),
    ),
    places('SELECT run, experiment, replicate FROM eea_runs ORDER BY run DESC', ([run, experiment, replicate]) => ({
      name: `${experiment} · run ${run} · replicate ${replicate}`,
      link: linkTo('run', { run }),
    })),
  ]);
  return found.flat();
}

/** Goes to revisions, trials, diagnoses and runs by words of their names. */
export function Finder() {
  const { source, version } = useContext(SharedContext);
  const [text, setText] = useState('');
  const [places, setPlaces] = useState<Place[]>([]);
  const looking = text !== '';
  useEffect(() => {
    if (looking) placesOf(source).then(setPlaces, () => setPlaces([]));
  }, [source, version, looking]);
  const found = useMemo(() => {
    const words = text.toLowerCase().split(/\s+/);
    return looking
      ? places.filter((one) => words.every((word) => one.name.toLowerCase().includes(word))).slice(0, kMostFound)
      : [];
  }, [places, text]);
  const field = useRef<HTMLInputElement>(null);
  const leave = () => {
    setText('');
    field.current?.blur(); // so that the next key is the page's
  };
  const go = (place: Place | undefined) => {
    if (!place) return;
    location.hash = place.link;
    leave();
  };
  return (
    <form
      class="finder"
      role="search"
      onSubmit={(event) => {
        event.preventDefault();
        go(found[0]);
      }}
    >
      <input
        ref={field}
        type="search"
        class="search"
        placeholder="find ( / )"
        aria-label="Find"
        value={text}
        onInput={(event) => setText(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === 'Escape') leave();
        }}
      />
      {looking && (
        <ul class="found">
          {found.map((one) => (
            <li key={one.link}>
              <a href={one.link} onClick={() => setText('')}>
                {one.name}
              </a>
            </li>
          ))}
          {found.length === 0 && <li class="muted">no page with this name</li>}
        </ul>
      )}
    </form>
  );
}
