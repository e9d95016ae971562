#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/csv_text.h"
#include "core/base/units.h"
#include "core/describe/figure.h"

namespace noonmark {

/// The figures by key, in the order of the table; what was not counted is null.
nlohmann::ordered_json figuresJson(const DescribedFigures& figures);

/// What the figures mean, by key.
nlohmann::ordered_json definitionsJson(std::span<const Figure> figures);

/// Reads what figuresJson() wrote, also in an earlier version. Null is NaN. Throws nlohmann's exceptions for
/// JSON of another structure, std::out_of_range for a count that is none.
template <class R>
R readFigures(const Figures<R>& table, const nlohmann::ordered_json& json);

/// The keys as columns of a table.
std::vector<std::string> listColumns(std::span<const Figure> figures);

/// Adds the figures to a row, with their decimals.
void addFigures(CsvText& csv, const DescribedFigures& figures);

/// What shares refer to, and what can be shown.
struct FigureContext {
    double areaM2 = 0;       ///< of the receivers; 0: no shares of it
    double sunlitMin = 0;    ///< a day; 0: no shares of it
    bool isInstant = false;  ///< of one moment: minutes mean nothing
    ShownAs show = ShownAs::shadow;
};

/// A figure with its value, for people.
struct FigureLine {
    const Figure* figure = nullptr;
    double value = 0;  ///< NaN: not counted
    double sharePct = std::numeric_limits<double>::quiet_NaN();
    std::string_view measure = {};            ///< "Gross", where several have the figure; NM_TEXT
    std::optional<double> thresholdMin = {};  ///< of figures by threshold
};

/// The lines of one use, in the order of the table, without those that have nothing to show and those that
/// are not shown where shadow or sun is.
std::vector<FigureLine> listLines(const DescribedFigures& figures, FigureUse use,
                                  const FigureContext& context = {});
/// Results, then what they refer to.
std::vector<FigureLine> listLines(const DescribedFigures& figures, const FigureContext& context = {});

/// "Shadow area"; "Gross: largest increase"; "Gross > 30 min: more shadow".
std::string labelOf(const FigureLine& line);
/// "3,833 m² (41.7 %)", "+1.25 min a day", "not counted".
std::string valueOf(const FigureLine& line, UnitSystem units = UnitSystem::metric);
/// "+1,204", "-3", "0": what rounds to zero has no sign.
std::string formatSigned(double value, int decimals);
/// "weighted shade +10 m² h, shadow area 9 m²"
std::string joinLines(const std::vector<FigureLine>& lines);
/// "Shadow area: sum over the receivers ... . Mean gross: ..."; each figure once.
std::string definitionsOf(const std::vector<FigureLine>& lines);

/// With a small letter at the beginning: "shadow area".
std::string lowered(std::string_view label);
/// " min a day"; empty for areas, which depend on the units in use. NM_TEXT
std::string_view unitText(FigureUnit unit);

namespace figures {
double readFigure(const Figure& figure, const nlohmann::ordered_json& json);
}

template <class R>
R readFigures(const Figures<R>& table, const nlohmann::ordered_json& json) {
    R result;
    for (const Figure& figure : table.rows())
        if (figure.inFiles) figure.set(&result, figures::readFigure(figure, json));
    return result;
}

}  // namespace noonmark
