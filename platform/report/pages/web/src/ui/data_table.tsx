import { useEffect, useRef } from 'preact/hooks';
import {
  FilterModule,
  FormatModule,
  InteractionModule,
  ResizeColumnsModule,
  SortModule,
  Tabulator,
  type CellComponent,
  type ColumnDefinition,
  type RowComponent,
} from 'tabulator-tables';
import type { Cell, Table } from '../data/source';
import { cellText } from '../kit/format';

Tabulator.registerModule([SortModule, FormatModule, FilterModule, ResizeColumnsModule, InteractionModule]);

interface Props {
  table: Table;
  /** How a column's cells are written; every digit where it is not said. */
  formats?: Record<string, (cell: Cell) => string>;
  /** A column that is as wide as its text. */
  wide?: string;
  /** What a click on a row does, or Enter where a row has the focus. */
  pick?: (row: number) => void;
  /** Rows that are shown; all where there is none. */
  accept?: (row: Cell[]) => boolean;
}

/** Text and nothing else: what stands in a database must never become markup. */
const textNode = (text: string) => {
  const node = document.createElement('span');
  node.textContent = text.length > 2000 ? `${text.slice(0, 2000)} …` : text;
  node.title = text.length > 40 ? text.slice(0, 4000) : '';
  node.dir = 'auto';
  return node;
};

const compare = (a: unknown, b: unknown) => {
  if (a === b) return 0;
  if (a === null || a === undefined) return -1;
  if (b === null || b === undefined) return 1;
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  return cellText(a) < cellText(b) ? -1 : 1;
};

function columnsOf({ table, formats, wide }: Props): ColumnDefinition[] {
  const canRest = !matchMedia('(hover: none)').matches;
  return table.columns.map((name, i) => {
    const numeric = table.rows.some((row) => typeof row[i] === 'number');
    return {
      title: ' ',
      field: `c${i}`,
      hozAlign: numeric ? 'right' : 'left',
      headerHozAlign: numeric ? 'right' : 'left',
      sorter: compare,
      // Where no pointer can rest on a cell it is as wide as its text, and the table scrolls.
      ...(canRest && name !== wide ? { maxInitialWidth: 360 } : {}),
      titleFormatter: () => textNode(name),
      formatter: (cell: CellComponent) => textNode((formats?.[name] ?? cellText)(cell.getValue() as Cell)),
    };
  });
}

/** Rows can be reached with the tab key and with arrows, and chosen with Enter. */
function leadByKeys(row: RowComponent, pick: () => void): void {
  const element = row.getElement();
  element.tabIndex = 0;
  element.onkeydown = (event) => {
    const next = { ArrowDown: element.nextElementSibling, ArrowUp: element.previousElementSibling }[event.key];
    if (event.key === 'Enter') pick();
    else if (next instanceof HTMLElement) next.focus();
    else return;
    event.preventDefault();
  };
}

const rowsOf = (table: Table) =>
  table.rows.map((row, index) => Object.fromEntries([['index', index], ...row.map((cell, i) => [`c${i}`, cell])]));

const kFewRows = 12;

/** A table of any size: only the rows that are seen are in the page. Other rows of the same columns take the place of
 *  the old ones without losing how they are sorted. */
export function DataTable(props: Props) {
  const box = useRef<HTMLDivElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const shown = useRef<Tabulator | null>(null);
  const drawn = useRef<Table | null>(null);
  const isLong = props.table.rows.length > kFewRows;
  const filter = () => {
    const { accept, table } = latest.current;
    if (accept) shown.current?.setFilter((row) => latest.current.accept!(table.rows[row.index as number]));
  };
  const pick = (row: RowComponent) => latest.current.pick?.(row.getData().index as number);
  useEffect(() => {
    drawn.current = latest.current.table;
    const table = new Tabulator(box.current!, {
      data: rowsOf(latest.current.table),
      columns: columnsOf(latest.current),
      layout: 'fitDataFill',
      index: 'index',
      ...(isLong ? { height: 320 } : {}),
      renderVerticalBuffer: 200,
      ...(latest.current.pick ? { rowFormatter: (row: RowComponent) => leadByKeys(row, () => pick(row)) } : {}),
    });
    table.on('rowClick', (_, row) => pick(row));
    table.on('tableBuilt', () => {
      shown.current = table;
      update();
      filter();
    });
    return () => {
      shown.current = null;
      table.destroy();
    };
  }, [props.table.columns.join(), isLong]);
  const update = () => {
    if (!shown.current || drawn.current === latest.current.table) return;
    drawn.current = latest.current.table;
    void shown.current.replaceData(rowsOf(latest.current.table)).then(filter);
  };
  useEffect(update, [props.table]);
  useEffect(filter, [props.accept]);
  return <div class={`data-table ${props.pick ? 'pickable' : ''}`} ref={box} />;
}
