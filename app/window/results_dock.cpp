#include "app/window/results_dock.h"

#include <QFormLayout>
#include <QLabel>
#include <QLocale>

#include "app/report/shadow_measure.h"

namespace noonmark {

namespace {

QString number(double value, int decimals) {
    return QLocale(QLocale::English).toString(value, 'f', decimals);
}

double accumulateSeconds(const Study& study) {
    const auto found = study.seconds.find("accumulate");
    return found == study.seconds.end() ? 0 : found->second;
}

Figure speed(const Study& study) {
    const double seconds = accumulateSeconds(study);
    const double megaRays = seconds > 0 ? double(study.field.cost.rays) / seconds * 1e-6 : 0;
    return {QObject::tr("Rays"), number(megaRays, 1) + QStringLiteral(" M/s"),
            QObject::tr("Occlusion rays traced, millions a second of the accumulate stage")};
}

Figure minutes(const QString& name, double value, const QString& meaning) {
    return {name, number(value, 1) + QStringLiteral(" min"), meaning};
}

QString engineText(const Study& study) {
    const QString text = QString::fromStdString(study.field.engine);
    return text.isEmpty() ? QString::fromStdString(study.settings.engine) : text;
}

std::vector<Figure> shadowFigures(const ShadowStatistics& s) {
    return {
        {QObject::tr("Shadow area"), number(s.shadowAreaM2, 0) + QStringLiteral(" m²"),
         QObject::tr("Sum over the receivers of (share of the sunlit time in shadow × cell area)")},
        {QObject::tr("of the ground"),
         number(s.receiverAreaM2 > 0 ? 100 * s.shadowAreaM2 / s.receiverAreaM2 : 0, 1) + QStringLiteral(" %"),
         QObject::tr("Shadow area over the area of all receivers")},
        minutes(QObject::tr("Mean gross"), s.meanGrossMin,
                QObject::tr("Minutes in shadow a day, mean over days and receivers")),
        minutes(QObject::tr("Mean continuous"), s.meanContinuousMin,
                QObject::tr("Longest unbroken run in shadow on any day, mean over the receivers")),
        minutes(QObject::tr("Max continuous"), s.maxContinuousMin,
                QObject::tr("Longest unbroken run in shadow of any receiver on any day")),
        {QObject::tr("Receivers"), number(double(s.receivers), 0),
         QObject::tr("Cells of open ground in the region")},
    };
}

}  // namespace

std::vector<Figure> figuresOf(const Study& study) {
    std::vector<Figure> figures = shadowFigures(study.statistics);
    figures.push_back({QObject::tr("Sun"), number(double(study.sun.steps.size()), 0) + QObject::tr(" steps"),
                       QObject::tr("Positions of the sun above the horizon; %1 below it were left out")
                           .arg(study.sun.belowHorizon)});
    if (study.field.cost.rays > 0) figures.push_back(speed(study));
    figures.push_back({QObject::tr("Time"), number(accumulateSeconds(study), 2) + QStringLiteral(" s"),
                       QObject::tr("Seconds that the engine took")});
    figures.push_back({QObject::tr("Period"), QString::fromStdString(textOf(study.settings.period)), {}});
    figures.push_back({QObject::tr("Engine"), engineText(study), {}});
    return figures;
}

ResultsDock::ResultsDock(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)), note_(new QLabel) {
    note_->setWordWrap(true);
    form_->addRow(note_);
    show(nullptr);
}

void ResultsDock::show(const Study* study) {
    while (form_->rowCount() > 1) form_->removeRow(1);
    filled_ = study != nullptr;
    note_->setText(tr("No study yet."));
    note_->setVisible(!filled_);
    if (!study) return;
    for (const Figure& figure : figuresOf(*study)) {
        auto* value = new QLabel(figure.value);
        value->setWordWrap(true);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setToolTip(figure.meaning);
        form_->addRow(figure.name, value);
        form_->labelForField(value)->setToolTip(figure.meaning);
    }
}

void ResultsDock::setOutdated(bool outdated) {
    if (!filled_) return;
    note_->setText(tr("The settings have changed since this study: run again."));
    note_->setVisible(outdated);
}

}  // namespace noonmark
