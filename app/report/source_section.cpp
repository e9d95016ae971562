#include <algorithm>
#include <array>

#include "app/report/report_sections.h"
#include "app/report/study_words.h"
#include "core/study/region_text.h"
#include "core/study/repeat_command.h"

namespace noonmark {

namespace {

constexpr std::size_t mostInputs = 5;
constexpr std::size_t mostWarnings = 7;

TextBlock heading(const char* text) { return {TextKind::heading, QString::fromUtf8(text)}; }
TextBlock body(const QString& text) { return {TextKind::body, text}; }

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
    TextBlocks blocks{heading("Inputs")};
    const std::size_t shown = std::min(mostInputs, study.inputs.size());
    for (std::size_t i = 0; i < shown; ++i) addInput(blocks, study.inputs[i]);
    if (shown < study.inputs.size())
        blocks.push_back(
            body(QStringLiteral("and %1 more: see study.json").arg(study.inputs.size() - shown)));
    if (study.inputs.empty())
        blocks.push_back(body(QStringLiteral("No file: the city was not read from one.")));
    return blocks;
}

struct HeightCounts {
    std::array<std::size_t, 4> bySource{};
    std::size_t parts = 0;
};

HeightCounts countHeights(const City& city) {
    HeightCounts counts;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts) {
            ++counts.bySource[std::size_t(part.heightSource)];
            ++counts.parts;
        }
    return counts;
}

QString heightWords(const Study& study) {
    const HeightCounts counts = countHeights(study.city);
    const auto count = [&](HeightSource source) { return countWords(counts.bySource[std::size_t(source)]); };
    return QStringLiteral(
               "%1 buildings in %2 parts: %3 parts with a measured height, %4 from their levels × %5 m, %6 "
               "assumed to be "
               "%7 m high, %8 three-dimensional in the data.")
        .arg(countWords(study.city.buildings.size()), countWords(counts.parts), count(HeightSource::measured),
             count(HeightSource::levels), amountWords(study.reading.metresPerLevel, 2),
             count(HeightSource::assumed), amountWords(study.reading.defaultHeightM, 2),
             count(HeightSource::mesh));
}

QString groupWords(const WarningGroup& group) {
    const std::string_view kind = nameOf(group.kind);
    return QStringLiteral("%1 %2: %3")
        .arg(countWords(group.where.size()), QString::fromUtf8(kind.data(), qsizetype(kind.size())),
             QString::fromStdString(group.what));
}

QString warningWords(std::vector<WarningGroup> groups) {
    std::ranges::stable_sort(groups, std::greater<>{},
                             [](const WarningGroup& group) { return group.where.size(); });
    QStringList lines;
    for (std::size_t i = 0; i < std::min(mostWarnings, groups.size()); ++i) lines << groupWords(groups[i]);
    if (groups.size() > mostWarnings)
        lines << QStringLiteral("%1 more kinds").arg(groups.size() - mostWarnings);
    return lines.join(QStringLiteral("; "));
}

QString warningsWords(const Study& study) {
    if (study.warnings.empty()) return QStringLiteral("None: every feature was taken as it is.");
    return QStringLiteral("%1. Each of the %2, with its feature: see study.json.")
        .arg(warningWords(grouped(study.warnings)), countWords(study.warnings.size()));
}

QString costWords(const Study& study) {
    const Cost& cost = study.field.cost;
    QStringList words{QStringLiteral("%1 of %2 buildings used")
                          .arg(countWords(cost.buildingsUsed), countWords(study.city.buildings.size()))};
    if (cost.rays > 0) words << QStringLiteral("%1 rays").arg(countWords(cost.rays));
    for (const auto& [reason, count] : cost.skipped)
        if (count > 0)
            words << QStringLiteral("skipped %1 %2").arg(countWords(count), QString::fromStdString(reason));
    const auto total = study.seconds.find("total");
    if (total != study.seconds.end()) words << QStringLiteral("%1 s in all").arg(amountWords(total->second));
    return words.join(QStringLiteral("; ")) + QStringLiteral(".");
}

}  // namespace

std::vector<TextBlocks> sourceSections(const Study& study) {
    return {inputsOf(study),
            {heading("Heights"), body(heightWords(study))},
            {heading("Warnings"), body(warningsWords(study))},
            {heading("Computed and left undone"), body(costWords(study))}};
}

TextBlocks repeatBlocks(const Study& study) {
    QString command = QString::fromStdString(repeatCommand(study));
    command.replace(u'\n', QChar(QChar::LineSeparator));
    TextBlocks blocks{heading("How to repeat it"), {TextKind::code, command}};
    if (!boxTextOf(study.settings.region, study.city.frame))
        blocks.push_back(
            body(QStringLiteral("%1 lies beside this report.").arg(QString::fromUtf8(regionFileName))));
    return blocks;
}

}  // namespace noonmark
