#pragma once

#include <chrono>
#include <filesystem>
#include <iosfwd>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/base/command_line.h"
#include "core/base/progress.h"
#include "core/base/warnings.h"
#include "core/describe/figure_text.h"
#include "core/measures/shown_error.h"
#include "core/study/study.h"

namespace noonmark {
struct TiledStudy;  // core/study/tiles/tiled_study.h
}

namespace noonmark::cli {

/// Lines of "label  value" with aligned values.
class Table {
public:
    void add(std::string label, std::string value) { rows_.emplace_back(std::move(label), std::move(value)); }
    void print(std::ostream& out) const;

private:
    std::vector<std::pair<std::string, std::string>> rows_;
};

/// A row for each figure.
void addFigures(Table& table, const std::vector<FigureLine>& lines);
/// The same on one row: "more shadow 12 m2, less shadow 0 m2".
void addFigures(Table& table, std::string label, const std::vector<FigureLine>& lines);

/// A row for each: "error: mean sun of a place".
void addErrors(Table& table, std::span<const ShownError> errors);

/// "1,234,567"
std::string withCommas(std::size_t number);

/// Prints a heading and one line per group of warnings; nothing without warnings.
void printWarnings(std::ostream& out, const Warnings& warnings);

/// Prints a study as text: figures, cost, files written and warnings.
void printStudy(const Study& study, const std::vector<std::filesystem::path>& files, std::ostream& out);
void printStudy(const TiledStudy& tiled, const std::vector<std::filesystem::path>& files, std::ostream& out);

/// Shows progress on one line that is rewritten in place if `err` is a terminal, otherwise nothing. The line
/// is cleared at the end.
class ProgressLine final : public Progress {
public:
    explicit ProgressLine(const Console& console) : console_(console) {}
    ~ProgressLine() override;
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void report(double fraction, std::string_view stage) override;

private:
    const Console& console_;
    std::mutex mutex_;
    std::optional<std::chrono::steady_clock::time_point> shown_;
};

}  // namespace noonmark::cli
