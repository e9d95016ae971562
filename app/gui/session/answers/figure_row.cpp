#include "app/gui/session/answers/figure_row.h"

#include "app/gui/base/widgets/translated.h"

namespace noonmark {

ResultRow figureRow(std::span<const Figure> figures, std::string_view key, const QString& value) {
    const Figure& figure = findFigure(figures, key);
    return {translated(figure.label), value, translatedSentence(figure.definition)};
}

}  // namespace noonmark
