#include <gtest/gtest.h>

#include <cmath>

#include "app/report/sheets/report_sections.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

QString methodTextOf(const Study& study) {
    QString text;
    for (const TextBlocks& section : methodSections(study))
        for (const TextBlock& block : section) text += block.text + u' ';
    return text.replace(QChar(QChar::Nbsp), u' ');
}

Study byTheSweep() {
    Study study = tests::syntheticStudy();
    study.settings.engine = "horizon";
    study.field.engineKey = "horizon";
    return study;
}

TEST(ErrorSection, SaysWhatWasMeasured) {
    Study study = byTheSweep();
    study.error = SampledError{.receivers = 300, .ofReceivers = 9200, .areaPct = -0.0123};
    study.error->gross = {.meanMin = 0.36, .p99Min = 1.8, .maxMin = 3.6, .wholeMin = 360};
    const QString text = methodTextOf(study);
    EXPECT_TRUE(text.contains("Measured on 300 of the 9,200 receivers")) << text.toStdString();
    EXPECT_TRUE(text.contains("off by -0.0123 % of the ground")) << text.toStdString();
    EXPECT_TRUE(text.contains("0.1 % in the mean, 0.5 % at the 99th percentile, 1 % (3.6 min)"))
        << text.toStdString();
}

TEST(ErrorSection, LeavesOutContinuousShadowThatWasNotCounted) {
    Study study = tests::grossOnly(byTheSweep());
    study.error = SampledError{.receivers = 300, .ofReceivers = 9200};
    study.error->gross = {.meanMin = 0.36, .p99Min = 1.8, .maxMin = 3.6, .wholeMin = 360};
    EXPECT_TRUE(methodTextOf(study).contains("continuous shadow by"));
    study.error->continuous.meanMin = std::nan("");
    const QString text = methodTextOf(study);
    EXPECT_FALSE(text.contains("continuous", Qt::CaseInsensitive)) << text.toStdString();
    EXPECT_TRUE(text.contains("of the sunlit time. ")) << text.toStdString();
    const auto definitions = definitionBlocks(study);
    EXPECT_TRUE(definitions.back().text == QStringLiteral("Continuous shadow was not counted."))
        << definitions.back().text.toStdString();
}

TEST(ErrorSection, SaysWhatWasSwitchedOffAndWhatTheReferenceIs) {
    Study study = byTheSweep();
    study.settings.errorSample.receivers = 0;
    EXPECT_TRUE(methodTextOf(study).contains("switched off"));
    EXPECT_TRUE(methodTextOf(tests::syntheticStudy()).contains("one exact test"));
}

}  // namespace
}  // namespace noonmark
