#pragma once

namespace CLI {
class App;
}

namespace lacuna {

/// Each adds one subcommand, whose callback does the work and throws `BadInput`, `Interrupted` or
/// `Error` where it fails. One file a command.
void add_check_command(CLI::App& program);
void add_new_command(CLI::App& program);
void add_fit_command(CLI::App& program);
void add_compare_command(CLI::App& program);
void add_diagnose_command(CLI::App& program);
void add_add_command(CLI::App& program);
void add_undo_command(CLI::App& program);
void add_export_command(CLI::App& program);
void add_history_command(CLI::App& program);
void add_plugins_command(CLI::App& program);
void add_trial_command(CLI::App& program);
void add_run_command(CLI::App& program);
void add_runs_command(CLI::App& program);
void add_predict_command(CLI::App& program);
void add_plot_command(CLI::App& program);
void add_curves_command(CLI::App& program);
void add_replay_command(CLI::App& program);
void add_reproduce_command(CLI::App& program);
void add_hash_command(CLI::App& program);
void add_plan_command(CLI::App& program);
void add_task_command(CLI::App& program);
void add_status_command(CLI::App& program);
void add_merge_command(CLI::App& program);
void add_backup_command(CLI::App& program);
void add_verify_command(CLI::App& program);
void add_sql_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_serve_command(CLI::App& program);
void add_completion_command(CLI::App& program);
void add_man_command(CLI::App& program);
void add_mcp_command(CLI::App& program);
void add_help_command(CLI::App& program);

/// Exit codes: 0 done, 1 failed, 2 bad input, 75 interrupted, by Ctrl-C or --time-limit, and to be resumed.
int run_program(int argc, char** argv);

}  // namespace lacuna
