#include <algorithm>

#include "app/report/report_sections.h"
#include "app/report/study_words.h"
#include "core/study/height_words.h"
#include "core/study/region_text.h"
#include "core/study/repeat_command.h"

namespace noonmark {

namespace {

constexpr std::size_t mostInputs = 5;
constexpr std::size_t mostWarnings = 6;

void addInput(TextBlocks& blocks, const InputFile& input) {
    const QString name = QString::fromStdString(input.path.filename().string());
    if (input.sha256.empty()) {
        blocks.push_back(body(QStringLiteral("%1, made by this program").arg(name)));
        return;
    }
    blocks.push_back(body(QStringLiteral("%1, %2 bytes, SHA-256:").arg(name, countWords(input.bytes))));
    blocks.push_back({TextKind::code, QString::fromStdString(input.sha256)});
}

TextBlocks inputsOf(const Study& study) {
    TextBlocks blocks{heading(QStringLiteral("Inputs"))};
    const std::size_t shown = std::min(mostInputs, study.inputs.size());
    for (std::size_t i = 0; i < shown; ++i) addInput(blocks, study.inputs[i]);
    if (shown < study.inputs.size())
        blocks.push_back(
            body(QStringLiteral("and %1 more: see study.json").arg(study.inputs.size() - shown)));
    if (study.inputs.empty())
        blocks.push_back(body(QStringLiteral("No file: the city was not read from one.")));
    return blocks;
}

QString heightWords(const Study& study) {
    const HeightCounts counts = countHeights(study.city);
    QStringList words;
    const auto add = [&](HeightSource source, const QString& meaning) {
        const std::size_t parts = counts.of(source);
        if (parts > 0) words << countWords(parts) + u' ' + meaning;
    };
    add(HeightSource::measured, QStringLiteral("measured"));
    add(HeightSource::levels,
        QStringLiteral("from levels × %1 m").arg(amountWords(study.reading.metresPerLevel, 2)));
    add(HeightSource::assumed,
        QStringLiteral("not in the data, so that a default stands in (%1 m for a whole building)")
            .arg(amountWords(study.reading.defaultHeightM, 2)));
    add(HeightSource::mesh, QStringLiteral("three-dimensional in the data"));
    add(HeightSource::designed, QStringLiteral("designed: stated by the scenario"));
    add(HeightSource::madeUp, QStringLiteral("made up: a sample, of no real place"));
    return QStringLiteral("%1 buildings in %2 parts. Heights of the parts: %3.")
        .arg(countWords(study.city.buildings.size()), countWords(counts.parts),
             words.join(QStringLiteral("; ")));
}

TextBlocks heightsOf(const Study& study) {
    TextBlocks blocks{heading(QStringLiteral("Heights")), body(heightWords(study))};
    for (const HeightField& field : study.heights.fields)
        blocks.push_back(body(QStringLiteral("From %1.").arg(QString::fromStdString(wordsOf(field)))));
    return blocks;
}

QString groupWords(const WarningGroup& group) {
    const std::string_view kind = nameOf(group.kind);
    return QStringLiteral("%1 %2: %3")
        .arg(countWords(group.where.size()), QString::fromUtf8(kind.data(), qsizetype(kind.size())),
             QString::fromStdString(group.what));
}

/// The most frequent kinds, one a line.
TextBlocks warningsOf(const Study& study) {
    TextBlocks blocks{heading(QStringLiteral("Warnings"))};
    std::vector<WarningGroup> groups = grouped(study.warnings);
    std::ranges::stable_sort(groups, std::greater<>{},
                             [](const WarningGroup& group) { return group.where.size(); });
    for (std::size_t i = 0; i < std::min(mostWarnings, groups.size()); ++i)
        blocks.push_back(body(groupWords(groups[i])));
    if (groups.empty())
        blocks.push_back(body(QStringLiteral("None: every feature was taken as it is.")));
    else
        blocks.push_back(
            body(QStringLiteral("%1 in all, of %2 kinds; each of them, with its feature, is in study.json.")
                     .arg(countWords(study.warnings.size()), countWords(groups.size()))));
    return blocks;
}

QString skippedWords(const Cost& cost) {
    QStringList words;
    for (const auto& [reason, count] : cost.skipped)
        if (count > 0) words << countWords(count) + u' ' + QString::fromStdString(reason);
    return words.isEmpty() ? QStringLiteral("nothing") : words.join(QStringLiteral("; "));
}

QString costWords(const Study& study) {
    const Cost& cost = study.field.cost;
    QString words = QStringLiteral("%1 of %2 buildings used")
                        .arg(countWords(cost.buildingsUsed), countWords(study.city.buildings.size()));
    if (cost.rays > 0) words += QStringLiteral(", %1 rays").arg(countWords(cost.rays));
    const auto total = study.seconds.find("total");
    if (total != study.seconds.end())
        words += QStringLiteral(", %1 s in all").arg(amountWords(total->second));
    return words + QStringLiteral(". Skipped: ") + skippedWords(cost) + u'.';
}

}  // namespace

std::vector<TextBlocks> sourceSections(const Study& study) {
    return {inputsOf(study),
            heightsOf(study),
            warningsOf(study),
            {heading(QStringLiteral("Computed and left undone")), body(costWords(study))}};
}

TextBlocks repeatBlocks(const Study& study) {
    QString command = QString::fromStdString(repeatCommand(study));
    command.replace(u'\n', QChar(QChar::LineSeparator));
    TextBlocks blocks{heading(QStringLiteral("How to repeat it")), {TextKind::code, command}};
    if (!boxTextOf(study.settings.region, study.city.frame))
        blocks.push_back(
            body(QStringLiteral("%1 lies beside this report.").arg(QString::fromUtf8(regionFileName))));
    return blocks;
}

}  // namespace noonmark
