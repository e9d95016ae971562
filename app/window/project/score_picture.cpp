#include "app/window/project/score_picture.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "app/window/change_scale.h"
#include "app/window/field_picture.h"
#include "app/window/hover_text.h"

namespace noonmark {

namespace {

constexpr float noScore = 1e-6F;

}  // namespace

Legend legendOf(const Score& score) {
    Legend legend{QObject::tr("Shadow score"),
                  QObject::tr("weight × share of time"),
                  {},
                  false,
                  true,
                  {}};
    legend.wanted = true;
    const ChangeScale found = changeScaleOf(score.score, noScore);
    legend.scale = legendScale(std::max(found.usual, 0.01));
    if (found.most > legend.scale.top) legend.unit += QObject::tr(", largest ±%1").arg(found.most, 0, 'g', 3);
    return legend;
}

GroundPicture scorePicture(const Score& score, double top) {
    GroundPicture picture;
    picture.grid = score.grid;
    picture.pixels.reserve(score.score.size());
    for (const float value : score.score)
        picture.pixels.push_back(std::isnan(value) ? GroundPicture::Pixel{}
                                                   : pixelOf(impactColour(-double(value) / top)));
    return picture;
}

QString scoreText(const Score& score, glm::dvec2 point) {
    const auto cell = cellAt(score.grid, point);
    if (!cell) return {};
    const float value = score.score[*cell];
    if (std::isnan(value)) return QObject::tr("not measured here");
    return QObject::tr("score %1%2 m² a m²")
        .arg(value > 0 ? QStringLiteral("+") : QString())
        .arg(double(value), 0, 'f', 3);
}

}  // namespace noonmark
