import { useContext, useEffect, useRef, useState } from 'preact/hooks';
import { SharedContext, useRows } from '../data/use';
import type { Cell, Table } from '../data/source';
import { saveCsv } from '../kit/download';
import { count } from '../kit/format';
import { choose } from '../kit/route';
import { Chart } from '../ui/chart';
import { DataTable } from '../ui/data_table';
import { Figure } from '../ui/figure';
import { Empty, Key, Select, Show } from '../ui/parts';
import { axesOf, numericColumns } from './sql_plot';
import { unitOf } from './sql_units';

interface View {
  name: string;
  sentence: string;
  example: string;
}

// The first query is one that has a plot.
const kErrors = `SELECT experiment, revision, change, channel, unit, fit_rmse, held_out_rmse, times_floor
FROM error_by_revision ORDER BY experiment, revision`;
const kPasses = 'SELECT run, pass, trials, error, evaluations_so_far FROM error_by_pass ORDER BY run, pass';
const kSamples = `WITH newest AS (SELECT max(id) AS trace FROM traces WHERE kind = 'measured')
SELECT time, channel, value FROM samples
WHERE trace = (SELECT trace FROM newest)
  AND channel = (SELECT channel FROM samples WHERE trace = (SELECT trace FROM newest) LIMIT 1)`;
const kHas = `SELECT (SELECT count(DISTINCT revision) FROM error_by_revision) AS revisions,
  EXISTS (SELECT * FROM error_by_pass) AS passes, EXISTS (SELECT * FROM traces WHERE kind = 'measured') AS samples`;
const kNothing = ' '; // an address keeps it
const kMostPoints = 20_000;
const kMostRows = 50_000;
const kMostSavedRows = 1_000_000;
const kRowsOnPaper = 12; // more scroll

/** Of a table that there is not, the program would advise a command; here the list stands beside. */
const withAdvice = (message: string) =>
  message.replace(/(no such table: \S+?)(; to list the views: .*)?$/, '$1; see “Views” for the existing ones');

interface Has {
  revisions: number;
  passes: number;
  samples: number;
}

function firstQuery({ revisions, passes, samples }: Has): string {
  if (revisions > 1) return kErrors;
  if (passes) return kPasses;
  return revisions === 1 && samples ? kSamples : kErrors;
}

/** Any query that reads, its result as table, picture and file. */
export function SqlPage({ choices }: { choices: Record<string, string> }) {
  const has = useRows<Has>(kHas);
  return <Show of={has}>{([found]) => <Page first={firstQuery(found)} choices={choices} />}</Show>;
}

function Page({ first, choices }: { first: string; choices: Record<string, string> }) {
  const [begun] = useState(first); // whatever is stored meanwhile, what a reader edits stays
  return <Asked asked={choices.q ?? begun} choices={choices} />;
}

function Asked({ asked, choices }: { asked: string; choices: Record<string, string> }) {
  const { source } = useContext(SharedContext);
  const [text, setText] = useState(asked.trim());
  const [answer, setAnswer] = useState<(Answer & { to: string }) | null>(null);
  const editor = useRef<HTMLTextAreaElement>(null);
  const ran = useRef(asked);
  const question = `${choices.again ?? ''} ${asked}`;
  useEffect(() => {
    // Not what was asked here: the reader may be typing the next query by now.
    if (asked.trim() !== ran.current.trim()) setText(asked.trim());
    ran.current = asked;
    if (asked.trim() === '') return;
    let wanted = true;
    const began = performance.now();
    source.ask(asked, kMostRows).then(
      (table) => wanted && setAnswer({ to: question, table, ms: performance.now() - began }),
      (error: Error) => wanted && setAnswer({ to: question, error: withAdvice(error.message) }),
    );
    return () => {
      wanted = false;
    };
  }, [source, question]);
  const run = (sql: string) => {
    ran.current = sql;
    setText(sql);
    choose({
      q: sql.trim() === '' ? kNothing : sql,
      x: null,
      y: null,
      as: null,
      again: sql === asked ? Date.now() % 1e6 : null,
    });
  };
  return (
    <div class="with-side">
      <section class="main-column">
        <form
          onSubmit={(event) => {
            event.preventDefault();
            run(text);
          }}
        >
          <textarea
            ref={editor}
            class="sql"
            rows={Math.min(14, Math.max(4, text.split('\n').length + 1))}
            spellcheck={false}
            aria-label="SQL"
            value={text}
            onInput={(event) => setText(event.currentTarget.value)}
            onKeyDown={(event) => {
              if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
                event.preventDefault();
                run(event.currentTarget.value);
              }
            }}
          />
          <pre class="on-paper">{asked.trim()}</pre>
          <div class="choices off-paper">
            <button type="submit" class="primary">
              Run
            </button>
            <span class="note">
              <Key>ctrl</Key> <Key>enter</Key> · read only
            </span>
          </div>
        </form>
        <Answered answer={answer?.to === question ? answer : null} asked={asked} choices={choices} />
      </section>
      <aside class="side off-paper">
        <Views run={run} />
      </aside>
    </div>
  );
}

interface Answer {
  table?: Table;
  error?: string;
  ms?: number;
}

/** Never the answer to another question. */
function Answered({
  answer,
  asked,
  choices,
}: {
  answer: Answer | null;
  asked: string;
  choices: Record<string, string>;
}) {
  if (asked.trim() === '') return <Empty>Type a query, or choose a view.</Empty>;
  if (answer === null) return <p class="empty loading">running …</p>;
  if (answer.error !== undefined)
    return (
      <p class="error" role="alert">
        {answer.error}
      </p>
    );
  return <Result table={answer.table!} ms={answer.ms ?? 0} choices={choices} sql={asked} />;
}

interface ResultProps {
  table: Table;
  ms: number;
  choices: Record<string, string>;
  sql: string;
}

function Result({ table, ms, choices, sql }: ResultProps) {
  const { source } = useContext(SharedContext);
  const [note, setNote] = useState('');
  // Every row, not only those that are shown.
  const keep = async () => {
    try {
      const all = table.cut ? await source.ask(sql, kMostSavedRows) : table;
      saveCsv(all.columns, all.rows, 'query');
      setNote(all.cut ? `The file has only the first ${count(all.rows.length)} rows.` : '');
    } catch (error) {
      setNote(error instanceof Error ? error.message : String(error));
    }
  };
  const rows = `${count(table.rows.length)} ${table.rows.length === 1 ? 'row' : 'rows'}`;
  return (
    <>
      <Figure
        title={`${table.cut ? `first ${rows}` : rows} · ${Math.round(ms)} ms`}
        downloads={[{ label: 'CSV', run: keep }]}
        note={[
          table.cut ? `Only the first ${rows} are shown; select others with LIMIT and WHERE. CSV has all.` : '',
          note,
        ].join(' ')}
      >
        {table.rows.length === 0 ? <Empty>No rows.</Empty> : <DataTable table={table} />}
      </Figure>
      {table.rows.length > kRowsOnPaper && (
        <p class="note on-paper">The print has the rows of the screen; the CSV file has all.</p>
      )}
      {table.rows.length > 1 && <Plot table={table} choices={choices} />}
    </>
  );
}

function Plot({ table, choices }: { table: Table; choices: Record<string, string> }) {
  const axes = axesOf(table, choices);
  if (!axes) return null;
  const { x, y, kind } = axes;
  const rows = table.rows.slice(0, kMostPoints);
  const number = (cell: Cell) => (typeof cell === 'number' ? cell : NaN);
  const options = numericColumns(table).map(({ name }) => ({ value: name, label: name }));
  return (
    <>
      <div class="choices">
        <Select label="x" value={x.name} options={options} change={(value) => choose({ x: value })} />
        <Select label="y" value={y.name} options={options} change={(value) => choose({ y: value })} />
        <Select
          label="as"
          value={kind}
          options={[
            { value: 'points', label: 'points' },
            { value: 'line', label: 'line' },
          ]}
          change={(value) => choose({ as: value })}
        />
      </div>
      <Chart
        title={`${y.name} over ${x.name}`}
        x={{ label: x.name, unit: unitOf(table, x.i), whole: x.isWhole }}
        y={{ label: y.name, unit: unitOf(table, y.i) }}
        series={[
          {
            name: '',
            kind,
            colour: 'predicted',
            x: rows.map((row) => number(row[x.i])),
            y: rows.map((row) => number(row[y.i])),
          },
        ]}
        note={
          table.rows.length > kMostPoints
            ? `The first ${count(kMostPoints)} rows.`
            : 'Units are SI; schema/database.md names them column by column.'
        }
      />
    </>
  );
}

function Views({ run }: { run: (sql: string) => void }) {
  const views = useRows<View>('SELECT name, sentence, example FROM page_view ORDER BY position');
  const [filter, setFilter] = useState('');
  return (
    <>
      <h2>Views</h2>
      <input
        type="search"
        class="search"
        placeholder="search ( / )"
        aria-label="Search the views"
        value={filter}
        onInput={(event) => setFilter(event.currentTarget.value)}
      />
      <Show of={views}>
        {(all) => (
          <dl class="views">
            {all
              .filter((one) => `${one.name} ${one.sentence}`.toLowerCase().includes(filter.toLowerCase()))
              .map((one) => (
                <div key={one.name}>
                  <dt>
                    <button class="link" onClick={() => run(one.example)}>
                      <code>{one.name}</code>
                    </button>
                  </dt>
                  <dd>{one.sentence}</dd>
                </div>
              ))}
          </dl>
        )}
      </Show>
    </>
  );
}
