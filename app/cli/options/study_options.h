#pragma once

// The folder app/cli/options/ holds the options that several commands share. Each header has structs with the
// values as given by the user, functions that add the options to a command, and where needed functions that
// parse them: this file for days and hours and for whole studies, sheet_options.h for commands that
// measure, the others for reading, projects, engines and outputs.

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "app/cli/options/shared_options.h"
#include "app/report/maps/style.h"
#include "core/describe/command_options.h"
#include "core/measures/legend_choice.h"
#include "core/study/elements/element_study.h"
#include "core/sun/period.h"

namespace noonmark::cli {

/// The days and hours of a command, as given by the user.
struct PeriodOptions {
    FlagNames names{};  ///< of flags that differ on this command
    Period period{};
    std::set<std::string, std::less<>> given{};  ///< flags of periodFields() that the user gave
    [[nodiscard]] bool states(std::string_view flag) const { return given.contains(flag); }
};

/// Returns the option of the first day, which the caller may require. `options` must outlive the parsing.
CLI::Option* addPeriodOptions(CLI::App& command, PeriodOptions& options);

/// The period, checked. Error: a zone that is unknown or, where clock hours need it, not given.
Result<Period> periodFrom(const PeriodOptions& options);

/// The options of `study`, as given by the user.
struct StudyOptions {
    ReadOptions read;
    PeriodOptions period;
    std::string scenario;    ///< scenario of a project; empty: not given
    std::string periodName;  ///< period of a project; if empty, `period` counts
    std::string region;
    std::string out;
    bool overwrite = false;
    bool withProject = false;  ///< copy the project beside the files
    StudySettings settings;    ///< the values that need neither the city nor further parsing
    bool json = false;
    bool cellsCsv = false;
    int pictureWidth = noonmark::pictureWidth;  ///< of shadow.png, pixels
    LegendChoice legend;                        ///< of maps and pages
    std::optional<ElementPlaces> points;        ///< measure points instead of cells
    ElementSettings elements;                   ///< where they are
};

/// Where a command can measure.
enum class ReceiverChoice { cells, cellsAndPoints };

/// Adds the options of every study.
void addStudyOptions(CLI::App& command, StudyOptions& options, ReceiverChoice choice = ReceiverChoice::cells);

/// Adds the options of points: --facades-of, --facing, --windows, --plane-height, --parcel, --points
/// and what belongs to them.
void addElementOptions(CLI::App& command, StudyOptions& options);

/// Adds --face, --facing, --facing-place and --within.
void addFaceOptions(CLI::App& command, FaceChoice& faces);

/// Adds --windows and how the file is read.
void addGlazingFileOptions(CLI::App& command, ElementSettings& elements);

/// What the options of points lack or have too much. Call it before the city is read.
Result<void> checkElementOptions(const StudyOptions& options);

/// Adds --by month.
void addMonthOption(CLI::App& command, StudySettings& settings);

/// Adds the options of `study` that tiles may lack: months, contributions, width of the picture, cells as a
/// table.
void addPieceOptions(CLI::App& command, StudyOptions& options);

/// Adds --error-sample and --no-error-sample.
void addErrorOptions(CLI::App& command, ErrorSampleSettings& sample);

/// Adds --cell, --pressure and --temperature.
void addCellOptions(CLI::App& command, StudySettings& settings);

/// Adds --engine and --option.
void addEngineOptions(CLI::App& command, StudySettings& settings);

}  // namespace noonmark::cli
