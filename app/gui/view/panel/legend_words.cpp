#include "app/gui/view/panel/legend_words.h"

#include <QCoreApplication>

#include "app/gui/base/widgets/number_words.h"

namespace noonmark {

namespace {

// What shadow_measure.cpp, legend_painter.cpp, impact_legend.cpp, score_legend.cpp and the window's
// verdict_tiles.cpp write.
[[maybe_unused]] constexpr const char* words[] = {
    QT_TRANSLATE_NOOP("Legend", "Gross shadow"),
    QT_TRANSLATE_NOOP("Legend", "Continuous shadow"),
    QT_TRANSLATE_NOOP("Legend", "minutes in shadow a day"),
    QT_TRANSLATE_NOOP("Legend", "longest run, minutes"),
    QT_TRANSLATE_NOOP("Legend", "Hours of sun"),
    QT_TRANSLATE_NOOP("Legend", "hours of sun a day"),
    QT_TRANSLATE_NOOP("Legend", "Share of the sunlit time"),
    QT_TRANSLATE_NOOP("Legend", "% in the sun"),
    QT_TRANSLATE_NOOP("Legend", "Change of sun"),
    QT_TRANSLATE_NOOP("Legend", "Change of gross shadow"),
    QT_TRANSLATE_NOOP("Legend", "Change of continuous shadow"),
    QT_TRANSLATE_NOOP("Legend", "min a day"),
    QT_TRANSLATE_NOOP("Legend", "min"),
    QT_TRANSLATE_NOOP("Legend", "scale fitted to this difference"),
    QT_TRANSLATE_NOOP("Legend", "scale locked: %1"),
    QT_TRANSLATE_NOOP("Legend", "largest %1"),
    QT_TRANSLATE_NOOP("Legend", "Shadow"),
    QT_TRANSLATE_NOOP("Legend", "at this moment"),
    QT_TRANSLATE_NOOP("Legend", "Shadow score"),
    QT_TRANSLATE_NOOP("Legend", "weight × share of time"),
    QT_TRANSLATE_NOOP("Legend", "Sun by place"),
    QT_TRANSLATE_NOOP("Legend", "Change of sun by place"),
    QT_TRANSLATE_NOOP("Legend", "minutes of sun a day"),
    QT_TRANSLATE_NOOP("Legend", "built over"),
    QT_TRANSLATE_NOOP("Legend", "now ground"),
    QT_TRANSLATE_NOOP("Legend", "in the sun"),
    QT_TRANSLATE_NOOP("Legend", "in shadow"),
    QT_TRANSLATE_NOOP("Legend", "Verdicts on windows"),
    QT_TRANSLATE_NOOP("Legend", "before"),
    QT_TRANSLATE_NOOP("Legend", "after"),
    QT_TRANSLATE_NOOP("Legend", "Change of verdicts"),
    QT_TRANSLATE_NOOP("Legend", "from before to after"),
    QT_TRANSLATE_NOOP("Legend", "pass"),
    QT_TRANSLATE_NOOP("Legend", "borderline"),
    QT_TRANSLATE_NOOP("Legend", "fail"),
    QT_TRANSLATE_NOOP("Legend", "not applicable"),
    QT_TRANSLATE_NOOP("Legend", "worse"),
    QT_TRANSLATE_NOOP("Legend", "better"),
    QT_TRANSLATE_NOOP("Legend", "the same"),
    QT_TRANSLATE_NOOP("Legend", "not compared"),
};

// Words before a number: "largest 12".
QString translatePart(const QString& part) {
    for (const QString& words : {QStringLiteral("scale locked: "), QStringLiteral("largest ")})
        if (part.startsWith(words))
            return translateLegendWord(words + QStringLiteral("%1")).arg(part.mid(words.size()));
    return translateLegendWord(part);
}

// A unit has parts between commas: "min a day, scale fitted to this difference, largest 12".
QString translateParts(const QString& unit) {
    QStringList parts = unit.split(QStringLiteral(", "));
    for (QString& part : parts) part = localiseNumbers(translatePart(part));
    return parts.join(QStringLiteral(", "));
}

}  // namespace

QString translateLegendWord(const QString& word) {
    return QCoreApplication::translate("Legend", word.toUtf8().constData());
}

Legend translateLegend(Legend legend) {
    legend.title = translateLegendWord(legend.title);
    legend.unit = translateParts(legend.unit);
    for (LegendPatch& patch : legend.classes) patch.label = translateLegendWord(patch.label);
    for (LegendPatch& patch : legend.patches) patch.label = translateLegendWord(patch.label);
    return legend;
}

}  // namespace noonmark
