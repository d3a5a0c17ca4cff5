import type { ComponentType } from 'preact';
import { ComparePage } from './compare';
import { DiagnosePage } from './diagnose';
import { HistoryPage } from './history';
import { OverviewPage } from './overview';
import { ReplayPage } from './replay';
import { RunPage } from './run';
import { RunsPage } from './runs';
import { SqlPage } from './sql';

export interface PageEntry {
  name: string;
  title: string;
  sentence: string;
  Page: ComponentType<{ choices: Record<string, string> }>;
}

/** In the order of their keys, 1 to 8; the first is where a reader begins. */
export const pages: PageEntry[] = [
  { name: 'overview', title: 'Overview', sentence: 'State of each experiment and the next step', Page: OverviewPage },
  { name: 'compare', title: 'Compare', sentence: 'Measured and predicted curves, and where they differ', Page: ComparePage },
  { name: 'diagnose', title: 'Diagnose', sentence: 'The missing effect', Page: DiagnosePage },
  { name: 'history', title: 'History', sentence: 'Error by revision', Page: HistoryPage },
  { name: 'run', title: 'Run', sentence: 'One run of the algorithm', Page: RunPage },
  { name: 'runs', title: 'Runs', sentence: 'All runs and replicates', Page: RunsPage },
  { name: 'replay', title: 'Replay', sentence: 'Robots in motion', Page: ReplayPage },
  { name: 'sql', title: 'SQL', sentence: 'Any query', Page: SqlPage },
];
