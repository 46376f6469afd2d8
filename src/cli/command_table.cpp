#include "cli/command_table.h"

#include <array>

namespace orbs::cli {

// Each is defined in the file of its name: add_bench_command in bench_command.cpp.
using AddCommand = void(const command_line::Command& command, const Program& program, Action& action);
AddCommand add_run_command, add_serve_command, add_report_command, add_compare_command;
AddCommand add_doctor_command, add_list_command, add_plan_command;
AddCommand add_renderer_command, add_reference_command, add_completion_command;
AddCommand add_probe_command, add_qualify_command, add_bench_command, add_effect_cost_command;
AddCommand add_sensitivity_command, add_cost_command, add_stability_command, add_compare_runs_command;
AddCommand add_history_command, add_merge_command, add_submit_command, add_export_command;
AddCommand add_judge_command, add_manual_command;

namespace {

constexpr const char* kResults = "Run and see results";
constexpr const char* kLookUp = "Look up what there is";
constexpr const char* kSetUp = "Set up";
constexpr const char* kStudies = "Studies";

constexpr std::array kCommands{
    Command{"run", kResults, "Render a suite and judge the images", add_run_command},
    Command{"merge", kResults, "Put the shards of a run together", add_merge_command},
    Command{"submit", kResults, "Render a suite on a cluster", add_submit_command},
    Command{"export", kResults, "Write scenes for a renderer that is somewhere else", add_export_command},
    Command{"judge", kResults, "Judge the images that come back from there", add_judge_command},
    Command{"serve", kResults, "Show runs as a page in the browser, even while they go on",
            add_serve_command},
    Command{"report", kResults, "Write the page of a run as one HTML file", add_report_command},
    Command{"compare", kResults, "Compare two images by every metric, and tell bias from noise",
            add_compare_command},
    Command{"compare-runs", kResults, "Say what is worse or better in one run than in another, beyond chance",
            add_compare_runs_command},
    Command{"history", kResults, "Show verdicts, errors and times over many runs, and where they changed",
            add_history_command},
    Command{"doctor", kLookUp, "List the renderers: what is installed, its version, what it declares",
            add_doctor_command},
    Command{"list", kLookUp, "List suites, renderers, requirements, cases and scenes", add_list_command},
    Command{"plan", kLookUp, "Show which effects of light each scene calls for, and why", add_plan_command},
    Command{"renderer", kSetUp, "Add a renderer to configuration.json", add_renderer_command},
    Command{"reference", kSetUp, "Render references with the built-in tracer", add_reference_command},
    Command{"completion", kSetUp, "Print the completion of commands and options for a shell",
            add_completion_command},
    Command{"manual", kSetUp, "Print the manual page", add_manual_command},
    Command{"probe", kStudies, "Check that each renderer places camera, geometry and textures correctly",
            add_probe_command},
    Command{"qualify", kStudies, "Check that each gate rejects faulty images and accepts a good one",
            add_qualify_command},
    Command{"sensitivity", kStudies,
            "Measure which slight faults pass silently, and the rate of false alarms",
            add_sensitivity_command},
    Command{"cost", kStudies, "Measure how long each renderer takes to a given error", add_cost_command},
    Command{"stability", kStudies, "Measure how far each renderer's images follow changes of a scene",
            add_stability_command},
    Command{"bench", kStudies, "Measure speed and noise of renderers side by side", add_bench_command},
    Command{"effect-cost", kStudies,
            "Measure what each effect of light costs, and what leaving it out changes",
            add_effect_cost_command},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

}  // namespace orbs::cli
