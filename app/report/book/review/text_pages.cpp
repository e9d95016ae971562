#include <fmt/format.h>

#include <algorithm>

#include "app/report/book/flow.h"
#include "app/report/book/review/review_pages.h"
#include "app/report/sheets/report_sections.h"
#include "app/report/sheets/study_words.h"
#include "core/review/library/rule_text.h"
#include "core/review/rule/rule_names.h"
#include "core/study/text/review_text.h"

namespace noonmark {

namespace {

TextBlocks methodOf(const ReviewScene& scene) {
    const ReviewStudy& study = scene.source.study;
    const Observer& observer = scene.observer;
    TextBlocks blocks{heading(QStringLiteral("Method"))};
    const auto add = [&](const QString& text) { blocks.push_back(body(text)); };
    add(QStringLiteral(
            "Engine: %1. Receivers: centres of the square cells of %2 m that the places touch, each "
            "weighed by its share of the place, not under a building of baseline or proposal.")
            .arg(plainText(study.engine), describeAmount(study.settings.cellM, 2)));
    const std::size_t days = scene.sun.sun.days.size();
    add(QStringLiteral("Time: %1 %2, %3 steps of %4 min with the sun in the rule's hours. Clock: %5.")
            .arg(describeCount(days), days == 1 ? QStringLiteral("day") : QStringLiteral("days"),
                 describeCount(scene.sun.sun.steps.size()), describeAmount(study.stepMinutes, 4),
                 plainText(study.clock)));
    add(QStringLiteral("Sun: ERFA, topocentric, seen from %1; apparent altitude, with refraction.")
            .arg(describeLatLon(observer.place)));
    add(QStringLiteral("Frame: metres to the east and true north of %1 (WGS84).")
            .arg(describeLatLon(scene.source.baseline.frame.origin())));
    add(QStringLiteral(
        "Incremental shadow lies on what is sunlit in the baseline; sun gained is the reverse."));
    blocks.push_back(heading(QStringLiteral("Error")));
    add(QString::fromStdString(describeReviewErrors(study)));
    add(
        QStringLiteral("The outlines in diagrams are exact unions of projected buildings where the ground is "
                       "level; the figures come from the cells."));
    blocks.push_back(heading(QStringLiteral("Not modelled")));
    add(QStringLiteral(
        "Trees, small structures and penumbra; the sun is a point at the centre of its disc."));
    for (const std::string& text : study.notChecked) add(plainText(text));
    return blocks;
}

// The title of a list is a heading, which stays with the list's first line.
TextBlocks ruleBlocks(const Rule& rule) {
    TextBlocks blocks{heading(QStringLiteral("The rule, as it was read"))};
    const QStringList lines = QString::fromStdString(describeRule(rule)).split(u'\n', Qt::SkipEmptyParts);
    const QString item = QStringLiteral("  - ");
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const bool isTitle =
            !lines[i].startsWith(item) && i + 1 < lines.size() && lines[i + 1].startsWith(item);
        if (!lines[i].trimmed().isEmpty())
            blocks.push_back(isTitle ? heading(plainText(lines[i])) : body(plainText(lines[i])));
    }
    return blocks;
}

void addBlocks(TextBlocks& to, const TextBlocks& blocks) {
    to.insert(to.end(), blocks.begin(), blocks.end());
}

/// Project, files, heights and warnings, as in the report of a study.
TextBlocks sourcesOf(const ReviewScene& scene) {
    Study study;
    study.city = scene.source.scenario;
    study.warnings = scene.source.study.warnings;
    study.provenance = scene.source.labels.provenance;
    study.heights = scene.source.heights;
    TextBlocks blocks;
    auto sections = sourceSections(study);
    sections.pop_back();  // cost and skipped work belong to a field
    for (const TextBlocks& section : sections) addBlocks(blocks, section);
    return blocks;
}

}  // namespace

std::vector<BookPage> makeMethodPages(const ReviewScene& scene) {
    TextBlocks blocks = methodOf(scene);
    addBlocks(blocks, sourcesOf(scene));
    addBlocks(blocks,
              repeatBlocks(makeRepeatCommand(scene.source.study, scene.source.labels, bookLetters), false));
    addBlocks(blocks, ruleBlocks(scene.source.study.rule));
    return makeTextPages(
        scene.settings.setup,
        {QStringLiteral("Method and sources"), {}, QStringLiteral("Method and sources"), 0, {}}, blocks);
}

}  // namespace noonmark
