#include <algorithm>

#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_words.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/text/height_words.h"
#include "core/study/text/region_text.h"

namespace noonmark {

namespace {

constexpr std::size_t mostInputs = 5;
constexpr std::size_t mostWarnings = 6;
constexpr std::size_t mostEdits = 5;

void addInput(TextBlocks& blocks, const InputFile& input) {
    const QString name = QString::fromStdString(input.path.filename().string());
    if (input.sha256.empty()) {
        blocks.push_back(body(QStringLiteral("%1, made by this program").arg(name)));
        return;
    }
    blocks.push_back(body(QStringLiteral("%1, %2 bytes, SHA-256:").arg(name, describeCount(input.bytes))));
    blocks.push_back({TextKind::code, QString::fromStdString(input.sha256)});
}

TextBlocks inputsOf(const Study& study) {
    TextBlocks blocks{heading(QStringLiteral("Inputs"))};
    const std::size_t shown = std::min(mostInputs, study.provenance.inputs.size());
    for (std::size_t i = 0; i < shown; ++i) addInput(blocks, study.provenance.inputs[i]);
    if (shown < study.provenance.inputs.size())
        blocks.push_back(
            body(QStringLiteral("and %1 more: see study.json").arg(study.provenance.inputs.size() - shown)));
    if (study.provenance.inputs.empty())
        blocks.push_back(body(QStringLiteral("No file: the city was not read from one.")));
    return blocks;
}

QString textOf(const std::string& text) { return QString::fromStdString(text); }

// Lists the first edits and the number of the others.
void addEdits(TextBlocks& blocks, const ScenarioRecord& scenario) {
    const std::size_t shown = std::min(mostEdits, scenario.edits.size());
    for (std::size_t i = 0; i < shown; ++i)
        blocks.push_back(body(QStringLiteral("%1. %2").arg(i + 1).arg(textOf(scenario.edits[i]))));
    if (shown < scenario.edits.size())
        blocks.push_back(
            body(QStringLiteral("and %1 more: see the JSON").arg(scenario.edits.size() - shown)));
}

void addScenario(TextBlocks& blocks, const QString& role, const ScenarioRecord& scenario) {
    const QString name = textOf(scenario.name);
    const std::size_t edits = scenario.edits.size();
    const QString what = edits == 1 ? QStringLiteral("edit") : QStringLiteral("edits");
    blocks.push_back(
        body(edits == 0 ? QStringLiteral("%1: %2, the city as it was read.").arg(role, name)
                        : QStringLiteral("%1: %2, %3 %4:").arg(role, name, describeCount(edits), what)));
    addEdits(blocks, scenario);
}

QString fileWords(const ProjectRecord& project) {
    if (project.file.empty()) return QStringLiteral("The project has not been saved yet.");
    if (!project.saved())
        return QStringLiteral("%1, which has not been saved since it was changed.").arg(textOf(project.file));
    return QStringLiteral("%1, SHA-256 of the file:").arg(textOf(project.file));
}

/// Empty for a city read directly from its files.
TextBlocks projectOf(const Study& study) {
    const auto& project = study.provenance.project;
    if (!project) return {};
    TextBlocks blocks{heading(QStringLiteral("Project and scenario")), body(fileWords(*project))};
    if (project->saved()) blocks.push_back({TextKind::code, textOf(project->fileSha256)});
    blocks.push_back(body(QStringLiteral("SHA-256 of the content it rests on (the JSON says of what):")));
    blocks.push_back({TextKind::code, textOf(project->contentSha256)});
    addScenario(blocks, QStringLiteral("Scenario"), project->scenario);
    if (project->baseline) addScenario(blocks, QStringLiteral("Baseline"), *project->baseline);
    return blocks;
}

QString heightWords(const Study& study) {
    const HeightCounts counts = countHeights(study.city);
    QStringList words;
    const auto add = [&](HeightSource source, const QString& meaning) {
        const std::size_t parts = counts.of(source);
        if (parts > 0) words << describeCount(parts) + u' ' + meaning;
    };
    add(HeightSource::measured, QStringLiteral("measured"));
    const auto& reading = study.provenance.reading;
    const auto metres = [&](double ReadSettings::*setting) {
        return reading ? describeAmount(*reading.*setting, 2) + QStringLiteral(" m")
                       : QStringLiteral("an unknown number of m");
    };
    add(HeightSource::levels, QStringLiteral("from levels × %1").arg(metres(&ReadSettings::metresPerLevel)));
    add(HeightSource::assumed,
        QStringLiteral("not in the data, so that a default stands in (%1 for a whole building)")
            .arg(metres(&ReadSettings::defaultHeightM)));
    add(HeightSource::mesh, QStringLiteral("three-dimensional in the data"));
    add(HeightSource::designed, QStringLiteral("designed: stated by the scenario"));
    add(HeightSource::madeUp, QStringLiteral("made up: a sample, of no real place"));
    return QStringLiteral("%1 buildings in %2 parts. Heights of the parts: %3.")
        .arg(describeCount(study.city.buildings.size()), describeCount(counts.parts),
             words.join(QStringLiteral("; ")));
}

TextBlocks heightsOf(const Study& study) {
    TextBlocks blocks{heading(QStringLiteral("Heights")), body(heightWords(study))};
    for (const HeightField& field : study.heights.fields)
        blocks.push_back(body(QStringLiteral("From %1.").arg(QString::fromStdString(describe(field)))));
    return blocks;
}

QString groupWords(const WarningGroup& group) {
    const std::string_view kind = nameOf(group.kind);
    return QStringLiteral("%1 %2: %3")
        .arg(describeCount(group.where.size()), QString::fromUtf8(kind.data(), qsizetype(kind.size())),
             QString::fromStdString(group.what));
}

/// The most frequent kinds, one per line.
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
        blocks.push_back(body(
            QStringLiteral(
                "%1 in all, of %2 kinds; each of them, with its feature, is in the JSON beside this report.")
                .arg(describeCount(study.warnings.size()), describeCount(groups.size()))));
    return blocks;
}

QString skippedWords(const Cost& cost) {
    QStringList words;
    for (const auto& [reason, count] : cost.skipped)
        if (count > 0) words << describeCount(count) + u' ' + QString::fromStdString(reason);
    return words.isEmpty() ? QStringLiteral("nothing") : words.join(QStringLiteral("; "));
}

QString costWords(const Study& study) {
    const Cost& cost = study.field.cost;
    QString words = QStringLiteral("%1 of %2 buildings used")
                        .arg(describeCount(cost.buildingsUsed), describeCount(study.city.buildings.size()));
    if (cost.rays > 0) words += QStringLiteral(", %1 rays").arg(describeCount(cost.rays));
    const auto total = study.seconds.find("total");
    if (total != study.seconds.end())
        words += QStringLiteral(", %1 s in all").arg(describeAmount(total->second));
    return words + QStringLiteral(". Skipped: ") + skippedWords(cost) + u'.';
}

}  // namespace

std::vector<TextBlocks> sourceSections(const Study& study) {
    std::vector<TextBlocks> sections{
        inputsOf(study),
        heightsOf(study),
        warningsOf(study),
        {heading(QStringLiteral("Computed and left undone")), body(costWords(study))}};
    if (study.provenance.project) sections.insert(sections.begin(), projectOf(study));
    return sections;
}

TextBlocks repeatBlocks(const Study& study) {
    return repeatBlocks(repeatCommand(study), needsRegionFile(study));
}

TextBlocks repeatBlocks(const Result<std::string>& command, bool withRegionFile) {
    TextBlocks blocks{heading(QStringLiteral("How to repeat it"))};
    if (!command) {
        blocks.push_back(body(QString::fromStdString(command.error().text())));
        return blocks;
    }
    QString text = QString::fromStdString(*command);
    text.replace(u'\n', QChar(QChar::LineSeparator));
    blocks.push_back({TextKind::code, text});
    if (withRegionFile)
        blocks.push_back(
            body(QStringLiteral("%1 lies beside this report.").arg(QString::fromUtf8(regionFileName))));
    return blocks;
}

}  // namespace noonmark
