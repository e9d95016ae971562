#include "app/window/time/time_looking.h"

namespace noonmark {

void TimeLooking::setStudy(std::shared_ptr<const Study> study) {
    if (study == study_) return;
    slot_.drop();
    study_ = std::move(study);
    kept_ = std::make_shared<Kept>();
    answer_.reset();
    Q_EMIT changed();
    ask();
}

void TimeLooking::look(const TimeLook& look) {
    if (look == look_) return;
    look_ = look;
    if (look_.span == TimeSpan::period && answer_) {
        answer_.reset();
        Q_EMIT changed();
    }
    if (!slot_.busy()) ask();
}

void TimeLooking::ask() {
    if (!study_ || look_.span == TimeSpan::period) return;
    asked_ = look_;
    slot_.start<TimeAnswer>(
        tr("Looking at %1").arg(wordsOf(look_)),
        [question = TimeAnswer{study_, look_, {}}, kept = kept_](Progress& progress, std::stop_token stop) {
            return answered(question, *kept, progress, stop);
        },
        [this](Result<TimeAnswer> answer) { take(std::move(answer)); });
}

Result<TimeAnswer> TimeLooking::answered(TimeAnswer question, Kept& kept, Progress& progress,
                                         const std::stop_token& stop) {
    const Study& study = *question.study;
    const Period period = periodOf(question.look, study.settings.period);
    const auto sun = sunSteps(period, observerOf(study), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    if (sun->steps.empty()) return failure("The sun is below the horizon", textOf(period), "Move the slider");
    if (!kept.horizons) {
        auto made = KeptHorizons::make(study.city, study.receivers);
        if (!made) return tl::make_unexpected(made.error());
        kept.horizons = std::move(*made);
    }
    auto field = kept.horizons->retime(*sun, progress, stop, KeptCounts::gross);
    if (!field) return tl::make_unexpected(field.error());
    question.field = std::move(*field);
    return question;
}

void TimeLooking::take(Result<TimeAnswer> answer) {
    if (look_.span == TimeSpan::period) return;
    if (answer) {
        answer_ = std::make_shared<const TimeAnswer>(*std::move(answer));
        Q_EMIT changed();
    } else if (!isCancelled(answer.error())) {
        Q_EMIT failed(asked_, answer.error());
    }
    if (asked_ != look_) ask();
}

}  // namespace noonmark
