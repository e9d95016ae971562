#include "app/gui/view/time/moment_preview.h"

#include <QLocale>

#include "app/gui/base/widgets/number_text.h"

namespace noonmark {

Period periodOf(const ShownTime& look, const Period& study) {
    Period period = study;
    if (look.span == ShownSpan::period) return period;
    period.start = look.date;
    period.days = 1;
    if (look.span == ShownSpan::day) return period;
    period.window.reset();
    period.from = look.at;
    period.hours = 0;
    return period;
}

ShownTime firstShownTime(const Period& study) {
    ShownTime look{ShownSpan::period, study.start};
    const auto middle = study.from + std::chrono::minutes(int(study.hours * 30));
    if (!study.window && middle <= std::chrono::hours(24)) look.at = middle;
    return look;
}

QString describe(const ShownTime& look) {
    if (look.span == ShownSpan::period) return {};
    const QString date = QLocale().toString(dateOf(look.date), longDate());
    if (look.span == ShownSpan::day) return date;
    return QStringLiteral("%1, %2").arg(date, QString::fromStdString(formatText(look.at)));
}

void MomentPreview::setStudy(std::shared_ptr<const Study> study) {
    if (study == study_) return;
    slot_.drop();
    study_ = std::move(study);
    answer_.reset();
    Q_EMIT changed();
    ask();
}

void MomentPreview::look(const ShownTime& look) {
    if (look == look_) return;
    look_ = look;
    if (look_.span == ShownSpan::period && answer_) {
        answer_.reset();
        Q_EMIT changed();
    }
    if (!slot_.busy()) ask();
}

void MomentPreview::ask() {
    if (!study_ || look_.span == ShownSpan::period) return;
    computed_ = look_;
    slot_.start<TimeAnswer>(
        tr("Computing %1").arg(describe(look_)),
        [question = TimeAnswer{study_, look_, {}}, horizons = horizons_](Progress& progress,
                                                                         const std::stop_token& stop) {
            return answered(question, *horizons, progress, stop);
        },
        [this](Result<TimeAnswer> answer) { take(std::move(answer)); });
}

Result<TimeAnswer> MomentPreview::answered(TimeAnswer question, SharedHorizonCache& horizons,
                                           Progress& progress, const std::stop_token& stop) {
    const Study& study = *question.study;
    const SunQuestion sun{periodOf(question.look, study.settings.period), makeObserver(study)};
    auto field = horizons.field(study.city, study.receivers, sun, ShadowCounts::gross, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    question.field = std::move(*field);
    return question;
}

void MomentPreview::take(Result<TimeAnswer> answer) {
    if (look_.span == ShownSpan::period) return;
    if (answer) {
        answer_ = std::make_shared<const TimeAnswer>(*std::move(answer));
        Q_EMIT changed();
    } else if (!isCancelled(answer.error())) {
        Q_EMIT failed(computed_, answer.error());
    }
    if (computed_ != look_) ask();
}

}  // namespace noonmark
