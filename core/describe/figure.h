#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/describe/shown_as.h"

namespace noonmark {

/// What people read a number in. Areas are written in the units in use, all others as they are.
enum class FigureUnit {
    none,
    squareMetres,
    squareMetreHours,
    minutes,
    minutesADay,
    hours,      ///< held in minutes
    hoursADay,  ///< held in minutes a day
    share,      ///< held as a share, 0 to 1
    percent,
};

/// What a figure is to those who read it.
enum class FigureUse {
    result,
    basis,  ///< what the results refer to: stands after them
    file,   ///< in files only
};

/// How the figures of pieces become that of the whole.
enum class Aggregation {
    sum,
    mean,  ///< weighted by what the pieces count
    max,
};

/// Which of several values of a figure is the best one.
enum class Better {
    none,  ///< none is better than another
    higher,
    lower,
    lessShadow,  ///< lower, but higher for those who want shade
};

/// What a figure is a part of; its share is shown, too.
enum class Whole { none, area, sunlitTime };

inline constexpr int allDigits = -1;

/// What is written down about one number of a result: JSON, CSV, tables, sheets and the GUI take key, label
/// and definition from here. Texts are in English and marked by NM_TEXT.
struct FigureFacts {
    std::string_view key;                  ///< of JSON and CSV, with its unit: "shadow_area_m2"
    std::string_view label = {};           ///< "Shadow area"
    std::string_view definition = {};      ///< begins in lower case and ends without a full stop
    int decimals = 1;                      ///< in CSV; allDigits: as many as the value needs
    std::optional<int> jsonDecimals = {};  ///< rounded to in JSON; none: all digits
    /// Its value in saved results of versions that did not state it; none: it was always stated.
    std::optional<double> valueIfMissing = {};
    FigureUnit unit = FigureUnit::none;
    FigureUse use = FigureUse::result;
    Whole whole = Whole::none;
    int shownDecimals = 1;  ///< to people; areas are shown without
    Aggregation together = Aggregation::sum;
    Better better = Better::none;
    bool isChange = false;        ///< shown with its sign
    bool onlyIfPositive = false;  ///< shown only then
    bool byThreshold = false;     ///< counts what is over a threshold
    ShownWith shownWith = ShownWith::always;
    bool inTable = false;  ///< a column of the tables that show only some of the figures
    bool inFiles = true;   ///< false: only people read it; it follows from others
};

/// A row of a table of figures. NaN stands for what was not counted. Its functions take the struct that the
/// table is of.
struct Figure : FigureFacts {
    bool isCount = false;  ///< a whole number
    std::function<double(const void*)> get{};
    std::function<void(void*, double)> set{};
};

/// Whether people are shown the figure where shadow or sun is shown. Files state all figures.
inline bool isShownAs(const FigureFacts& figure, ShownAs show) { return isShownAs(figure.shownWith, show); }

/// A result with its figures, as interfaces take it. Refers to both: a temporary only in its expression.
struct DescribedFigures {
    std::span<const Figure> figures;
    const void* object = nullptr;
    [[nodiscard]] double get(const Figure& figure) const { return figure.get(object); }
};

/// The row of a member that is a number.
template <class R, class M>
Figure figure(M R::*member, FigureFacts facts) {
    Figure row{facts, std::is_integral_v<M>};
    row.get = [member](const void* object) { return double(static_cast<const R*>(object)->*member); };
    row.set = [member](void* object, double value) { static_cast<R*>(object)->*member = M(value); };
    return row;
}

/// The row of what follows from other members; it is not read back.
template <class R>
Figure derivedFigure(double (*get)(const R&), FigureFacts facts) {
    Figure row{facts};
    row.get = [get](const void* object) { return get(*static_cast<const R*>(object)); };
    row.set = [](void*, double) {};
    return row;
}

/// The figures of R, in the order in which interfaces state them. Keys are unique.
template <class R>
class Figures {
public:
    Figures(std::initializer_list<Figure> rows) : rows_(rows) {}

    [[nodiscard]] std::span<const Figure> rows() const { return rows_; }
    [[nodiscard]] DescribedFigures of(const R& object) const { return {rows_, &object}; }

private:
    std::vector<Figure> rows_;
};

/// Adds the figures of a piece to those of the pieces before it. The weights are those of Aggregation::mean.
void addPiece(std::span<const Figure> figures, void* whole, double wholeWeight, const void* piece,
              double pieceWeight);

/// The row with this key, which must be in the table.
const Figure& findFigure(std::span<const Figure> figures, std::string_view key);

}  // namespace noonmark
