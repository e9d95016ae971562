#include "core/study/tile_tasks/plan/tile_subject.h"

#include "core/study/provenance/sha256.h"
#include "core/study/provenance/study_hash.h"

namespace noonmark {

std::string hashQuestion(const TaskQuestion& question) {
    StudySettings settings = question.settings;
    settings.region = {};
    const std::string hash = hashSettings(settings);
    if (question.subject == nullptr && question.places() == nullptr) return hash;
    Sha256 sum;
    sum.add(hash);
    if (question.subject != nullptr) sum.add(question.subject->key);
    if (question.timelines != nullptr) sum.add(question.timelines->key());
    if (question.byPlace != nullptr) sum.add(question.byPlace->key());
    return sum.hex();
}

}  // namespace noonmark
