#include "app/gui/docks/review/verdict_words.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <array>
#include <map>

#include "app/gui/base/widgets/number_words.h"
#include "core/review/library/rule_text.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

constexpr std::array shownOrder{Verdict::fail, Verdict::borderline, Verdict::pass, Verdict::notApplicable,
                                Verdict::notChecked};

void addCount(QStringList& parts, std::size_t count, Verdict verdict) {
    if (count > 0) parts << QStringLiteral("%1 %2").arg(formatCount(count), describeVerdict(verdict));
}

}  // namespace

QString describeVerdict(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return QObject::tr("✓ pass");
        case Verdict::borderline:
            return QObject::tr("≈ borderline");
        case Verdict::fail:
            return QObject::tr("✗ fail");
        case Verdict::notApplicable:
            return QObject::tr("– not applicable");
        case Verdict::notChecked:
            return QObject::tr("? not checked");
    }
    return {};
}

QString describeVerdict(const PlaceReview& review) {
    if (review.unjudged == noLimitForPlace) return QObject::tr("– figures only");
    return describeVerdict(review.verdict);
}

QString describeCounts(const VerdictCounts& counts) {
    QStringList parts;
    addCount(parts, counts.fail, Verdict::fail);
    addCount(parts, counts.borderline, Verdict::borderline);
    addCount(parts, counts.pass, Verdict::pass);
    addCount(parts, counts.notApplicable, Verdict::notApplicable);
    addCount(parts, counts.notChecked, Verdict::notChecked);
    return parts.join(QStringLiteral(", "));
}

QColor verdictColour(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return {0x00, 0x5f, 0x9e};
        case Verdict::borderline:
            return {0x7a, 0x5c, 0x00};
        case Verdict::fail:
            return {0xb0, 0x3a, 0x00};
        case Verdict::notApplicable:
        case Verdict::notChecked:
            break;
    }
    return {0x5c, 0x61, 0x6b};
}

QString describeVerdicts(const ReviewStudy& study) {
    // By verdict from fail to not checked; figures only stand beside what is not applicable.
    std::map<std::pair<int, QString>, std::size_t> counts;
    for (const PlaceReview& place : study.places) {
        const auto order = std::ranges::find(shownOrder, place.verdict) - shownOrder.begin();
        ++counts[{int(order), describeVerdict(place)}];
    }
    QStringList parts;
    for (const auto& [verdict, count] : counts)
        parts << QStringLiteral("%1 %2").arg(formatCount(count), verdict.second);
    return parts.join(QStringLiteral(", "));
}

QString describeStatus(const Rule& rule) {
    const FigureStatus status = leastSure(rule);
    const auto words = [](std::string_view text) {
        return QString::fromUtf8(text.data(), qsizetype(text.size()));
    };
    return QObject::tr("Least sure figure: %1 (%2)")
        .arg(words(ruleNameOf(figureStatusNames(), status)), words(meaningOf(status)));
}

}  // namespace noonmark
