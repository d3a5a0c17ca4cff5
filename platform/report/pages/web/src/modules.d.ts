declare module 'worker-text' {
  const text: string;
  export default text;
}
declare module '*.wasm' {
  const bytes: Uint8Array;
  export default bytes;
}
/** As much of sql.js as is used here. */
declare module 'sql.js/dist/sql-wasm-browser.js' {
  export type Value = number | string | Uint8Array | null;
  export interface Statement {
    bind(values: Value[]): boolean;
    step(): boolean;
    get(): Value[];
    get(values: null, how: { useBigInt: true }): (Value | bigint)[];
    getColumnNames(): string[];
    free(): boolean;
  }
  export interface Database {
    prepare(sql: string): Statement;
    iterateStatements(sql: string): Iterator<Statement> & { getRemainingSQL(): string };
    run(sql: string): Database;
    create_function(name: string, body: (...values: never[]) => Value): Database;
  }
  export default function initSqlJs(options: { wasmBinary: ArrayBuffer; useOldExtensionFunctions: boolean }): Promise<{
    Database: new (bytes: Uint8Array) => Database;
  }>;
}
/** As much of Tabulator as is used here. */
declare module 'tabulator-tables' {
  export interface CellComponent {
    getValue(): unknown;
    getElement(): HTMLElement;
  }
  export interface RowComponent {
    getData(): Record<string, unknown>;
    getElement(): HTMLElement;
  }
  export interface ColumnDefinition {
    title: string;
    field: string;
    [option: string]: unknown;
  }
  export class Tabulator {
    static registerModule(modules: unknown[]): void;
    constructor(element: HTMLElement, options: Record<string, unknown>);
    on(event: 'tableBuilt', callback: () => void): void;
    on(event: 'rowClick', callback: (event: Event, row: RowComponent) => void): void;
    replaceData(rows: unknown[]): Promise<void>;
    setFilter(filter: (row: Record<string, unknown>) => boolean): void;
    destroy(): void;
  }
  export const SortModule: unknown;
  export const FormatModule: unknown;
  export const FilterModule: unknown;
  export const EditModule: unknown;
  export const ResizeColumnsModule: unknown;
  export const InteractionModule: unknown;
}
