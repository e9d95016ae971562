#include "app/gui/base/layers/element_picture.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/base/widgets/number_words.h"

namespace noonmark {

namespace {

double minutesOf(const MeasuredElement& element, ShadowMeasure measure) {
    return measure == ShadowMeasure::gross ? element.grossMin : element.continuousMin;
}

}  // namespace

std::vector<ElementTiles::Tile> makeTiles(const ElementMap& map, ShadowMeasure measure,
                                          const ColourScale& scale) {
    std::vector<ElementTiles::Tile> tiles;
    tiles.reserve(map.elements.size());
    for (const MeasuredElement& element : map.elements) {
        const Rgb shade = scale.colourOf(scale.shownOf(minutesOf(element, measure)));
        tiles.push_back({cornersOf(element), glm::vec3(shade.red, shade.green, shade.blue) / 255.0F});
    }
    return tiles;
}

QString describe(const MeasuredElement& element) {
    QString text =
        QObject::tr("%1 h of sun a day, at most %2 h without a break")
            .arg(groupDigits(element.sunlitMin / 60, 1), groupDigits(element.longestSunMin / 60, 1));
    if (element.floor) text = QObject::tr("floor %1, %2").arg(*element.floor).arg(text);
    return text + QStringLiteral(", ") +
           formatMinutes(float(element.grossMin), float(element.continuousMin), false);
}

}  // namespace noonmark
