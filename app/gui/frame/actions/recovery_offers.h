#pragma once

#include <QObject>

#include "scenarios/project/recovery_file.h"

namespace noonmark {

class MessageBar;
class RecoveryStore;
class SavingActions;
class Workbench;

/// Offers the recovery files that earlier runs left for the open project, or for a project without a file.
class RecoveryOffers final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    RecoveryOffers(Workbench& workbench, const RecoveryStore& store, SavingActions& saving,
                   MessageBar& messages);

    void offer();  ///< what there is for the project that has been opened

private:
    void offerNewest(const std::filesystem::path& project, const Recovery& found);
    void offerOlder();
    void offerLeft();

    Workbench& workbench_;
    const RecoveryStore& store_;
    SavingActions& saving_;
    MessageBar& messages_;
};

}  // namespace noonmark
