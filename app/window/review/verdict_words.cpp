#include "app/window/review/verdict_words.h"

#include <QObject>
#include <QStringList>

#include "app/window/widgets/number_words.h"
#include "core/review/library/rule_text.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

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

QString describeCounts(const VerdictCounts& counts) {
    QStringList parts;
    const auto add = [&](std::size_t count, Verdict verdict) {
        if (count > 0) parts << QStringLiteral("%1 %2").arg(formatCount(count), describeVerdict(verdict));
    };
    add(counts.fail, Verdict::fail);
    add(counts.borderline, Verdict::borderline);
    add(counts.pass, Verdict::pass);
    add(counts.notApplicable, Verdict::notApplicable);
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

QString describeStatus(const Rule& rule) {
    const FigureStatus status = leastSure(rule);
    const auto words = [](std::string_view text) {
        return QString::fromUtf8(text.data(), qsizetype(text.size()));
    };
    return QObject::tr("Least sure figure: %1 (%2)")
        .arg(words(ruleNameOf(figureStatusNames(), status)), words(meaningOf(status)));
}

}  // namespace noonmark
