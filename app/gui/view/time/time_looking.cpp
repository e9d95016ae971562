#include "app/gui/view/time/time_looking.h"

namespace noonmark {

void TimeLooking::setStudy(std::shared_ptr<const Study> study) {
    if (study == study_) return;
    slot_.drop();
    study_ = std::move(study);
    answer_.reset();
    Q_EMIT changed();
    ask();
}

void TimeLooking::look(const TimeLook& look) {
    if (look == look_) return;
    look_ = look;
    if (look_.span == LookSpan::period && answer_) {
        answer_.reset();
        Q_EMIT changed();
    }
    if (!slot_.busy()) ask();
}

void TimeLooking::ask() {
    if (!study_ || look_.span == LookSpan::period) return;
    computed_ = look_;
    slot_.start<TimeAnswer>(
        tr("Computing %1").arg(describe(look_)),
        [question = TimeAnswer{study_, look_, {}}, horizons = horizons_](Progress& progress,
                                                                         const std::stop_token& stop) {
            return answered(question, *horizons, progress, stop);
        },
        [this](Result<TimeAnswer> answer) { take(std::move(answer)); });
}

Result<TimeAnswer> TimeLooking::answered(TimeAnswer question, SharedHorizonCache& horizons,
                                         Progress& progress, const std::stop_token& stop) {
    const Study& study = *question.study;
    const SunQuestion sun{periodOf(question.look, study.settings.period), makeObserver(study)};
    auto field = horizons.field(study.city, study.receivers, sun, ShadowCounts::gross, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    question.field = std::move(*field);
    return question;
}

void TimeLooking::take(Result<TimeAnswer> answer) {
    if (look_.span == LookSpan::period) return;
    if (answer) {
        answer_ = std::make_shared<const TimeAnswer>(*std::move(answer));
        Q_EMIT changed();
    } else if (!isCancelled(answer.error())) {
        Q_EMIT failed(computed_, answer.error());
    }
    if (computed_ != look_) ask();
}

}  // namespace noonmark
