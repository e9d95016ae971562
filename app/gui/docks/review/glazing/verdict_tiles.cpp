#include "app/gui/docks/review/glazing/verdict_tiles.h"

#include <QObject>
#include <array>

#include "app/gui/docks/review/verdict_words.h"
#include "app/report/maps/verdict_colour.h"
#include "core/describe/text.h"
#include "core/receivers/points/pane_corners.h"

namespace noonmark {

namespace {

constexpr std::array shownClasses{Verdict::pass, Verdict::borderline, Verdict::fail, Verdict::notApplicable};
constexpr std::array shownChanges{VerdictChange::same, VerdictChange::worse, VerdictChange::better,
                                  VerdictChange::notCompared};

// The words of legends are English here, as in files.
QString wordOf(VerdictChange change) {
    constexpr std::array words{NM_TEXT("the same"), NM_TEXT("worse"), NM_TEXT("better"),
                               NM_TEXT("not compared")};
    return QString::fromLatin1(words[std::size_t(change)]);
}

QColor colourOf(const GlazingReview& review, ShownVerdicts shown) {
    if (shown == ShownVerdicts::change) return tileColour(findChange(review));
    return tileColour(shown == ShownVerdicts::before ? review.formerVerdict : review.verdict);
}

Legend makeVerdictLegend(ShownVerdicts shown) {
    Legend legend;
    const bool ofChange = shown == ShownVerdicts::change;
    legend.title = ofChange ? QStringLiteral(NM_TEXT("Change of verdicts"))
                            : QStringLiteral(NM_TEXT("Verdicts on windows"));
    legend.unit = ofChange                         ? QStringLiteral(NM_TEXT("from before to after"))
                  : shown == ShownVerdicts::before ? QStringLiteral(NM_TEXT("before"))
                                                   : QStringLiteral(NM_TEXT("after"));
    if (ofChange)
        for (const VerdictChange change : shownChanges)
            legend.classes.push_back({tileColour(change), wordOf(change)});
    else
        for (const Verdict verdict : shownClasses)
            legend.classes.push_back({tileColour(verdict), QString::fromUtf8(nameOf(verdict).data())});
    return legend;
}

}  // namespace

VerdictChange findChange(const GlazingReview& review) {
    const auto isKnown = [](Verdict verdict) {
        return verdict != Verdict::notApplicable && verdict != Verdict::notChecked;
    };
    if (!isKnown(review.formerVerdict) || !isKnown(review.verdict)) return VerdictChange::notCompared;
    if (isWorse(review.formerVerdict, review.verdict)) return VerdictChange::worse;
    return isWorse(review.verdict, review.formerVerdict) ? VerdictChange::better : VerdictChange::same;
}

QColor tileColour(Verdict verdict) { return verdictMark(verdict); }

QColor tileColour(VerdictChange change) {
    switch (change) {
        case VerdictChange::worse:
            return tileColour(Verdict::fail);
        case VerdictChange::better:
            return tileColour(Verdict::pass);
        case VerdictChange::same:
            return {0xf4, 0xec, 0xd8};
        case VerdictChange::notCompared:
            break;
    }
    return {0x8a, 0x8d, 0x92};
}

QString describeVerdicts(const GlazingReview& review) {
    return QObject::tr("%1, floor %2   before: %3, after: %4")
        .arg(QString::fromStdString(review.window.id))
        .arg(review.window.floor)
        .arg(describeVerdict(review.formerVerdict), describeVerdict(review.verdict));
}

std::shared_ptr<const TileView> makeVerdictTiles(const std::shared_ptr<const GlazingAnswer>& answer,
                                                 ShownVerdicts shown) {
    if (!answer || shown == ShownVerdicts::none) return nullptr;
    const auto view = std::make_shared<TileView>();
    const GlazingStudy& study = answer->study;
    view->tiles.reserve(study.panes.size());
    for (const ReviewedPane& pane : study.panes) {
        const QColor colour = colourOf(study.windows[pane.window], shown);
        view->tiles.push_back({computePaneCorners(pane.pane.middle, pane.pane.normal, pane.pane.size),
                               glm::vec3(colour.redF(), colour.greenF(), colour.blueF())});
    }
    view->legend = makeVerdictLegend(shown);
    view->describe = [answer](std::size_t tile) {
        return describeVerdicts(answer->study.windows[answer->study.panes[tile].window]);
    };
    return view;
}

}  // namespace noonmark
