#include "app/gui/base/layers/score_picture.h"

#include <QObject>
#include <cmath>

#include "app/gui/base/layers/field_picture.h"
#include "app/gui/base/layers/hover_text.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/report/maps/score_legend.h"

namespace noonmark {

GroundPicture scorePicture(const Score& score, const ColourScale& scale) {
    GroundPicture picture;
    picture.grid = score.grid;
    picture.pixels.reserve(score.score.size());
    for (std::size_t cell = 0; cell < score.score.size(); ++cell) {
        const auto colour = pickColour(scale, double(score.score[cell]));
        picture.pixels.push_back(colour ? pixelOf(*colour) : GroundPicture::Pixel{});
    }
    return picture;
}

QString formatScore(const Score& score, glm::dvec2 point) {
    const auto cell = cellAt(score.grid, point);
    if (!cell) return {};
    const float value = score.score[*cell];
    if (std::isnan(value)) return QObject::tr("not measured");
    return QObject::tr("score %1%2 m² a m²")
        .arg(value > 0 ? QStringLiteral("+") : QString())
        .arg(groupDigits(double(value), 3));
}

}  // namespace noonmark
