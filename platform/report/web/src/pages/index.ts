import type { ComponentType } from 'preact';
import { ComparePage } from './compare';
import { SqlPage } from './sql';

export interface PageEntry {
  name: string;
  title: string;
  sentence: string;
  Page: ComponentType<{ choices: Record<string, string> }>;
}

export const pages: PageEntry[] = [
  { name: 'compare', title: 'Compare', sentence: 'Measured and predicted', Page: ComparePage },
  { name: 'sql', title: 'SQL', sentence: 'Any query', Page: SqlPage },
];
