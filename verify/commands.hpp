// The sub-commands of gpf. Each registers itself; when it runs it leaves the program's exit status in `status`.
#pragma once

namespace CLI {
class App;
}

namespace gpf {

void add_run_command(CLI::App& app, int& status);
void add_validate_command(CLI::App& app, int& status);
void add_explain_command(CLI::App& app, int& status);
void add_campaign_command(CLI::App& app, int& status);
void add_chart_command(CLI::App& app, int& status);
void add_advise_command(CLI::App& app, int& status);
void add_flow_command(CLI::App& app, int& status);
void add_faults_command(CLI::App& app, int& status);
void add_report_command(CLI::App& app, int& status);
void add_trial_command(CLI::App& app, int& status);
void add_trace_command(CLI::App& app, int& status);
void add_view_command(CLI::App& app, int& status);
void add_audit_command(CLI::App& app, int& status);
void add_export_command(CLI::App& app, int& status);
void add_pages_command(CLI::App& app, int& status);

}  // namespace gpf
