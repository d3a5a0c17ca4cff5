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
import { unitOf } from './sql_units';

interface View {
  name: string;
  sentence: string;
  example: string;
}

const kFirst = 'SELECT * FROM error_by_revision ORDER BY experiment, revision';
const kMostPoints = 20_000;
const kMostRows = 50_000;
const kMostSavedRows = 1_000_000;
const kRowsOnPaper = 12; // more scroll

/** Of a table that there is not, the program would advise a command; here the list stands beside. */
const withAdvice = (message: string) =>
  message.replace(/(no such table: \S+?)(; `lacuna sql .*)?$/, '$1; “What can be asked” has those that there are');

/** Any query that reads, its result as table, picture and file. */
export function SqlPage({ choices }: { choices: Record<string, string> }) {
  const { source } = useContext(SharedContext);
  const asked = choices.q ?? '';
  const [text, setText] = useState(asked || kFirst);
  const [answer, setAnswer] = useState<{ table?: Table; error?: string; ms?: number } | null>(null);
  const editor = useRef<HTMLTextAreaElement>(null);
  useEffect(() => {
    if (asked) setText(asked);
    let wanted = true;
    const began = performance.now();
    setAnswer(null);
    source.ask(asked || kFirst, kMostRows).then(
      (table) => wanted && setAnswer({ table, ms: performance.now() - began }),
      (error: Error) => wanted && setAnswer({ error: withAdvice(error.message) }),
    );
    return () => {
      wanted = false;
    };
  }, [source, asked, choices.again]);
  const run = (sql: string) => choose({ q: sql, x: null, y: null, again: sql === asked ? Date.now() % 1e6 : null });
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
          <pre class="on-paper">{asked || kFirst}</pre>
          <div class="choices off-paper">
            <button type="submit" class="primary">
              Run
            </button>
            <span class="note">
              <Key>ctrl</Key> <Key>enter</Key> · read only
            </span>
          </div>
        </form>
        {answer === null && <p class="empty loading">asking …</p>}
        {answer?.error !== undefined && (
          <p class="error" role="alert">
            {answer.error}
          </p>
        )}
        {answer?.table && <Result table={answer.table} ms={answer.ms ?? 0} choices={choices} sql={asked || kFirst} />}
      </section>
      <aside class="side off-paper">
        <Views run={run} />
      </aside>
    </div>
  );
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
      setNote(all.cut ? `The file has the first ${count(all.rows.length)} rows; there are more.` : '');
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
          table.cut ? `Only the first ${rows} are shown; LIMIT and WHERE choose others. CSV has all.` : '',
          note,
        ].join(' ')}
      >
        {table.rows.length === 0 ? <Empty>No row.</Empty> : <DataTable table={table} />}
      </Figure>
      {table.rows.length > kRowsOnPaper && (
        <p class="note on-paper">Paper has the rows that the screen had; the CSV file has all.</p>
      )}
      {table.rows.length > 1 && <Plot table={table} choices={choices} />}
    </>
  );
}

const isNumeric = (rows: Cell[][], column: number) =>
  rows.some((row) => typeof row[column] === 'number') &&
  rows.every((row) => row[column] === null || typeof row[column] === 'number');

function Plot({ table, choices }: { table: Table; choices: Record<string, string> }) {
  const numeric = table.columns.map((name, i) => ({ name, i })).filter(({ i }) => isNumeric(table.rows, i));
  if (numeric.length < 2) return null;
  const pick = (name: string | undefined, otherwise: number) =>
    numeric.find((one) => one.name === name) ?? numeric[otherwise];
  const x = pick(choices.x, 0),
    y = pick(choices.y, numeric.length - 1);
  const kind = choices.as === 'line' ? ('line' as const) : ('points' as const);
  const rows = table.rows.slice(0, kMostPoints);
  const number = (cell: Cell) => (typeof cell === 'number' ? cell : NaN);
  const options = numeric.map(({ name }) => ({ value: name, label: name }));
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
        x={{ label: x.name, unit: unitOf(table, x.i) }}
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
      <h2>What can be asked</h2>
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
