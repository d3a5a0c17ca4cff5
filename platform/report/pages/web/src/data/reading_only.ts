// What the server refuses (storage/core/reading_only.cpp), refused here.
const kBetween = /^(?:[\s;]|--[^\n]*(?:\n|$)|\/\*[^]*?(?:\*\/|$))*/;
const kAsking = [
  'table_info',
  'table_xinfo',
  'table_list',
  'index_list',
  'index_info',
  'foreign_key_list',
  'integrity_check',
  'quick_check',
  'foreign_key_check',
];
const kAskingWithoutValue = ['user_version', 'application_id', 'journal_mode', 'page_count', 'page_size', 'encoding'];

const kChanging =
  /^(alter|analyze|attach|begin|commit|create|delete|detach|drop|end|insert|pragma|reindex|release|replace|rollback|savepoint|update|vacuum)\b/i;

/** Whether the first of these statements may run: it reads, or there is none. */
export function isReading(statements: string): boolean {
  const text = statements.replace(kBetween, '');
  if (text === '') return true;
  const pragma = /^pragma\s+(?:\w+\s*\.\s*)?(\w+)\s*(.?)/i.exec(text);
  if (pragma) {
    const name = pragma[1].toLowerCase();
    return kAsking.includes(name) || (kAskingWithoutValue.includes(name) && (pragma[2] === '' || pragma[2] === ';'));
  }
  return !kChanging.test(text); // what is no statement at all SQLite says better
}
