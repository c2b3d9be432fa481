// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/feel_panel.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <QAction>
#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>

#include "editor/feel/feel_player.h"
#include "editor/feel/feel_settings.h"
#include "editor/feel/feel_setup.h"
#include "editor/feel/level_meter.h"
#include "editor/feel/press_pad.h"
#include "editor/feel/press_signal_source.h"
#include "editor/feel/press_strip.h"
#include "editor/feel/signal_view.h"
#include "editor/feel/sound_device_list.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double overPress = 1.25;     // as playback's standard press
constexpr double gainStepsPer_dB = 2;  // of the slider
constexpr double stripTail_s = 0.3;    // the strip runs on a little after a press
constexpr double figuresEvery_s = 0.25;
constexpr double wideRatio = 1.35;  // wider than this, the parts stand side by side

double fullForceOf(const playback::HapticProgram& program) {
  return std::max(overPress * playback::strongestForce_N(program), 4 * program.hysteresis_N);
}

double steady_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

PadButton padButtonOf(const Button& button, std::size_t state, double full_N) {
  const ButtonState& shown = button.states()[std::min(state, button.states().size() - 1)];
  const StrokeCurve& press = shown.graph.press();
  PadButton pad;
  pad.name = QString::fromStdString(button.name());
  pad.stateName = button.selfLocking() ? QString::fromStdString(shown.name) : QString();
  pad.start_mm = press.start_mm();
  pad.end_mm = press.end_mm();
  pad.full_N = full_N;
  pad.pressPoints = tactilePoints(press, Stroke::press);
  if (shown.graph.release())
    pad.releasePoints = tactilePoints(shown.graph.curve(Stroke::release), Stroke::release);
  pad.operating_mm = shown.operatingPoint_mm;
  pad.reset_mm = shown.resetPoint_mm;
  return pad;
}

}  // namespace

/// Everything behind the panel: two buttons, one finger, the widgets.
class FeelPanel::Parts : public QObject {
 public:
  Parts(FeelPanel& panel, ViewSettings& settings, const FeelDevices& devices);

  struct Slot {
    QPointer<ButtonDocument> document;
    PressSignalSource source;
    std::shared_ptr<const PressSignal> signal;
    bool stale = false;  ///< changed while nobody looked
    QToolButton* choice = nullptr;
  };

  Slot& felt() { return slots_[feltIndex_]; }
  void setDocument(std::size_t index, ButtonDocument* document);
  void feel(std::size_t index);
  void setSettings(const FeelSettings& settings);
  void request(Slot& slot);
  void layOut();

 private:
  void build(ViewSettings& settings);
  QWidget* buildChoices();
  QWidget* buildPresses();
  QWidget* buildSound();
  void connectParts();
  void connectPad();
  void offer(Slot& slot);
  void writeNames();
  void showFelt();
  void showPad();
  void showSound();
  void showStatus();
  void showPresses();
  void drawOwn(bool own);
  void play();
  void follow();
  void followState(std::size_t state);
  void onFelt(const std::vector<playback::EngineEvent>& events);
  void loadProfile();
  void connectSensor();
  double full_N();

  friend class FeelPanel;
  FeelPanel& panel_;
  FeelSettings settings_;
  std::optional<playback::DeviceProfile> profile_;
  SoundDeviceList devices_;
  FeelPlayer player_;
  std::array<Slot, 2> slots_;
  std::size_t feltIndex_ = 0, shownState_ = 0;
  std::shared_ptr<const playback::PressTrace> ownPress_;  ///< the last one by hand
  bool drawsOwn_ = false;
  double lastPressed_s_ = 0, lastDisplacement_mm_ = 0;
  bool wasPressed_ = false, releasing_ = false;
  SoundState shownSound_ = SoundState::off;
  double figuresAt_s_ = 0;

  QBoxLayout* sections_ = nullptr;
  QWidget* controls_ = nullptr;
  PressPad* pad_ = nullptr;
  PressStrip* strip_ = nullptr;
  SignalView* view_ = nullptr;
  LevelMeter* meter_ = nullptr;
  QToolButton *sound_ = nullptr, *setupToggle_ = nullptr;
  QSlider* gain_ = nullptr;
  QLabel *gainText_ = nullptr, *status_ = nullptr;
  QPushButton* again_ = nullptr;
  QScrollArea* setupArea_ = nullptr;
  FeelSetup* setup_ = nullptr;
  QAction *exchange_ = nullptr, *play_ = nullptr;
  QToolButton *standardPress_ = nullptr, *myPress_ = nullptr;
};

FeelPanel::Parts::Parts(FeelPanel& panel, ViewSettings& settings, const FeelDevices& devices)
    : panel_(panel), devices_(nullptr, devices), player_(nullptr, devices) {
  build(settings);
  connectParts();
  connectPad();
  setSettings({});
  showFelt();
  showSound();
}

// ---- widgets

void FeelPanel::Parts::build(ViewSettings& settings) {
  pad_ = new PressPad(settings);
  pad_->setObjectName("pressPad");
  strip_ = new PressStrip;
  strip_->setObjectName("pressStrip");
  view_ = new SignalView;
  view_->setObjectName("signalView");
  setup_ = new FeelSetup(settings, devices_);
  setupArea_ = new QScrollArea;
  setupArea_->setWidget(setup_);
  setupArea_->setWidgetResizable(true);
  setupArea_->setFrameShape(QFrame::NoFrame);
  setupArea_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setupArea_->setMinimumHeight(170);
  setupArea_->hide();

  auto* padColumn = new QWidget;
  auto* column = new QVBoxLayout(padColumn);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(buildChoices());
  column->addWidget(pad_, 1);
  column->addWidget(strip_);

  auto* viewColumn = new QWidget;
  auto* drawn = new QVBoxLayout(viewColumn);
  drawn->setContentsMargins(0, 0, 0, 0);
  drawn->setSpacing(6);
  drawn->addWidget(buildPresses());
  drawn->addWidget(view_, 1);

  controls_ = new QWidget;
  auto* controls = new QVBoxLayout(controls_);
  controls->setContentsMargins(0, 0, 0, 0);
  controls->setSpacing(6);
  controls->addWidget(buildSound());
  controls->addWidget(setupArea_, 1);
  controls->addStretch(0);

  sections_ = new QBoxLayout(QBoxLayout::TopToBottom, &panel_);
  sections_->setContentsMargins(8, 8, 8, 8);
  sections_->setSpacing(8);
  sections_->addWidget(padColumn, 5);
  sections_->addWidget(viewColumn, 4);
  sections_->addWidget(controls_, 0);
}

QWidget* FeelPanel::Parts::buildChoices() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  exchange_ = new QAction(FeelPanel::tr("Press the other button"), this);
  exchange_->setObjectName("exchangeButtons");
  exchange_->setShortcut(Qt::Key_X);
  exchange_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  exchange_->setToolTip(
      FeelPanel::tr("Exchange A and B under the finger. Both are played at their true levels: "
                    "nothing is made equally loud."));
  panel_.addAction(exchange_);
  auto* group = new QButtonGroup(row);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    auto* choice = new QToolButton;
    choice->setObjectName(i == 0 ? "feelA" : "feelB");
    choice->setCheckable(true);
    choice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    group->addButton(choice);
    layout->addWidget(choice, 1);
    slots_[i].choice = choice;
    connect(choice, &QToolButton::clicked, this, [this, i] { feel(i); });
  }
  auto* swap = new QToolButton;
  swap->setText(QStringLiteral("X"));
  swap->setObjectName("exchange");
  swap->setAccessibleName(exchange_->text());
  swap->setToolTip(exchange_->toolTip() + FeelPanel::tr(" (X)"));
  connect(swap, &QToolButton::clicked, exchange_, &QAction::trigger);
  connect(exchange_, &QAction::enabledChanged, swap, &QWidget::setEnabled);
  layout->addWidget(swap);
  return row;
}

/// Which press is drawn and played.
QWidget* FeelPanel::Parts::buildPresses() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* group = new QButtonGroup(row);
  const auto choice = [&](const QString& name, const QString& text, const QString& tip) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    group->addButton(button);
    layout->addWidget(button, 1);
    return button;
  };
  standardPress_ =
      choice("standardPress", FeelPanel::tr("Standard press"),
             FeelPanel::tr("Draw and play a standard press: rise 120 ms, hold 80 ms, fall 100 ms"));
  myPress_ =
      choice("myPress", FeelPanel::tr("My last press"),
             FeelPanel::tr("Draw and play your own last press, on A as on B and after every edit: the same "
                           "finger for each"));
  standardPress_->setChecked(true);
  connect(standardPress_, &QToolButton::clicked, this, [this] { drawOwn(false); });
  connect(myPress_, &QToolButton::clicked, this, [this] { drawOwn(true); });

  play_ = new QAction(FeelPanel::tr("Play the drawn press"), this);
  play_->setObjectName("playPress");
  play_->setShortcut(Qt::Key_P);
  play_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  play_->setToolTip(
      FeelPanel::tr("Play the press that is drawn on the sound device: the transducer moves by itself"));
  panel_.addAction(play_);
  connect(play_, &QAction::triggered, this, &Parts::play);
  auto* button = new QToolButton;
  button->setObjectName("play");
  button->setText(FeelPanel::tr("Play"));
  button->setAccessibleName(play_->text());
  button->setToolTip(play_->toolTip() + FeelPanel::tr(" (P)"));
  connect(button, &QToolButton::clicked, play_, &QAction::trigger);
  connect(play_, &QAction::enabledChanged, button, &QWidget::setEnabled);
  layout->addWidget(button);
  return row;
}

QWidget* FeelPanel::Parts::buildSound() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);

  auto* levels = new QHBoxLayout;
  sound_ = new QToolButton;
  sound_->setObjectName("soundSwitch");
  sound_->setText(FeelPanel::tr("Sound"));
  sound_->setCheckable(true);
  sound_->setToolTip(
      FeelPanel::tr("Play what is felt on the sound device. The device is opened by the first press, "
                    "and closed when this is switched off."));
  meter_ = new LevelMeter;
  meter_->setObjectName("levelMeter");
  setupToggle_ = new QToolButton;
  setupToggle_->setObjectName("setupToggle");
  setupToggle_->setText(FeelPanel::tr("Setup"));
  setupToggle_->setCheckable(true);
  setupToggle_->setArrowType(Qt::RightArrow);
  setupToggle_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setupToggle_->setToolTip(FeelPanel::tr("How the pad is pressed, what is felt, devices and force sensor"));
  levels->addWidget(sound_);
  levels->addWidget(meter_, 1);
  levels->addWidget(setupToggle_);
  column->addLayout(levels);

  auto* gain = new QHBoxLayout;
  auto* gainLabel = new QLabel(FeelPanel::tr("&Gain"));
  gain_ = new QSlider(Qt::Horizontal);
  gain_->setObjectName("gain");
  gain_->setRange(static_cast<int>(lowestGain_dB * gainStepsPer_dB),
                  static_cast<int>(highestGain_dB * gainStepsPer_dB));
  gain_->setPageStep(static_cast<int>(6 * gainStepsPer_dB));
  gain_->setTickInterval(static_cast<int>(20 * gainStepsPer_dB));
  gain_->setTickPosition(QSlider::TicksBelow);
  gain_->setToolTip(
      FeelPanel::tr("Gain before the limiter, −40 to +20 dB; 0 dB is what the button and the device "
                    "profile ask for"));
  gainLabel->setBuddy(gain_);
  gainText_ = new QLabel;
  gainText_->setMinimumWidth(gainText_->fontMetrics().horizontalAdvance("−40.0 dB"));
  gainText_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  gain->addWidget(gainLabel);
  gain->addWidget(gain_, 1);
  gain->addWidget(gainText_);
  column->addLayout(gain);

  auto* line = new QHBoxLayout;
  status_ = new QLabel;
  status_->setObjectName("soundStatus");
  status_->setWordWrap(true);
  status_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  again_ = new QPushButton(FeelPanel::tr("Try again"));
  again_->setObjectName("soundAgain");
  again_->setToolTip(FeelPanel::tr("Open the sound device once more"));
  line->addWidget(status_, 1);
  line->addWidget(again_);
  column->addLayout(line);
  return box;
}

void FeelPanel::Parts::layOut() {
  const bool wide = panel_.width() > wideRatio * panel_.height();
  sections_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  sections_->activate();
  writeNames();
  sections_->setStretch(2, wide ? 3 : (setupArea_->isVisibleTo(&panel_) ? 4 : 0));
}

void FeelPanel::Parts::connectParts() {
  for (Slot& slot : slots_) {
    connect(&slot.source, &PressSignalSource::ready, this,
            [this, &slot](const std::shared_ptr<const PressSignal>& signal) {
              if (!slot.document) return;
              slot.signal = signal;
              if (&slot == &felt()) showFelt();
            });
  }
  connect(exchange_, &QAction::triggered, this, [this] { feel(1 - feltIndex_); });
  connect(&player_, &FeelPlayer::moved, this, &Parts::follow);
  connect(&player_, &FeelPlayer::felt, this, &Parts::onFelt);
  connect(&player_, &FeelPlayer::recorded, this, [this](const auto& press) {
    ownPress_ = press;
    drawOwn(drawsOwn_);
    showPresses();
  });
  connect(&player_, &FeelPlayer::soundChanged, this, &Parts::showSound);
  connect(&player_, &FeelPlayer::sensorChanged, this, [this] {
    if (!player_.sensorTrouble().isEmpty() && !settings_.sensorPort.isEmpty()) {
      const QString port = settings_.sensorPort;
      settings_.sensorPort.clear();
      setup_->setSettings(settings_);
      setup_->offerPort(port);
    }
    setup_->setSensor(player_.status(), player_.sensorTrouble());
  });
  connect(setup_, &FeelSetup::changed, this, &Parts::setSettings);
  connect(sound_, &QToolButton::toggled, this, [this](bool on) {
    FeelSettings next = settings_;
    next.sound = on;
    setSettings(next);
  });
  connect(gain_, &QSlider::valueChanged, this, [this](int steps) {
    FeelSettings next = settings_;
    next.gain_dB = steps / gainStepsPer_dB;
    setSettings(next);
  });
  connect(again_, &QPushButton::clicked, this, [this] { player_.startSound(); });
  connect(setupToggle_, &QToolButton::toggled, this, [this](bool open) {
    setupToggle_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    setupArea_->setVisible(open);
    layOut();
  });
}

void FeelPanel::Parts::connectPad() {
  connect(pad_, &PressPad::timedDown, this, [this] { player_.down(full_N()); });
  connect(pad_, &PressPad::timedUp, &player_, &FeelPlayer::up);
  connect(pad_, &PressPad::forceMoved, this, [this](double share) { player_.pushForce(share * full_N()); });
  connect(pad_, &PressPad::depthMoved, this, [this](double share) {
    if (!felt().signal || !felt().signal->program) return;
    const playback::StateProgram& state = felt().signal->program->states[shownState_];
    player_.pushDepth(state.start_mm + share * (state.end_mm - state.start_mm));
  });
  connect(pad_, &PressPad::lifted, &player_, &FeelPlayer::lift);
}

// ---- documents

void FeelPanel::Parts::setDocument(std::size_t index, ButtonDocument* document) {
  Slot& slot = slots_[index];
  if (document != nullptr && slot.document == document) return;
  if (slot.document) slot.document->disconnect(this);
  slot.document = document;
  slot.signal.reset();
  if (document != nullptr) {
    connect(document, &ButtonDocument::changed, this, [this, index] { request(slots_[index]); });
    connect(document, &ButtonDocument::titleChanged, this, [this, index] { offer(slots_[index]); });
    connect(document, &QObject::destroyed, this, [this, index] { setDocument(index, nullptr); });
    request(slot);
  }
  for (Slot& each : slots_) offer(each);
  if (!felt().document && slots_[1 - feltIndex_].document) {
    feel(1 - feltIndex_);
  } else if (&slot == &felt()) {
    showFelt();
    emit panel_.feltDocumentChanged(felt().document);
  }
}

/// Names on the two buttons above the pad, and whether they can be pressed.
void FeelPanel::Parts::offer(Slot& slot) {
  const bool isA = &slot == &slots_[0];
  slot.choice->setEnabled(slot.document != nullptr);
  slot.choice->setToolTip(slot.document ? FeelPanel::tr("Press %1").arg(slot.document->title())
                          : isA         ? FeelPanel::tr("No button is open")
                                        : FeelPanel::tr("Choose a second button to compare with"));
  slot.choice->setAccessibleName(slot.choice->toolTip());
  exchange_->setEnabled(slots_[0].document && slots_[1].document);
  writeNames();
}

/// As much of the names as there is room for.
void FeelPanel::Parts::writeNames() {
  for (const Slot& slot : slots_) {
    const QString letter = &slot == &slots_[0] ? QStringLiteral("A") : QStringLiteral("B");
    const QString name = slot.document ? slot.document->title() : QStringLiteral("–");
    slot.choice->setText(slot.choice->fontMetrics().elidedText(letter + "  " + name, Qt::ElideRight,
                                                               slot.choice->width() - 14));
  }
}

void FeelPanel::Parts::request(Slot& slot) {
  slot.stale = !panel_.isVisible();
  if (slot.stale || !slot.document) return;
  playback::PlaybackSettings settings;
  settings.mode = settings_.mode;
  settings.placement = settings_.placement;
  slot.source.request({slot.document->button(), profile_.value_or(playback::DeviceProfile{}), settings,
                       drawsOwn_ ? ownPress_ : nullptr});
}

void FeelPanel::Parts::drawOwn(bool own) {
  const bool changes = own || own != drawsOwn_;
  drawsOwn_ = own;
  if (!changes) return;
  for (Slot& slot : slots_) request(slot);
}

void FeelPanel::Parts::play() {
  const std::shared_ptr<const PressSignal>& signal = felt().signal;
  if (!signal || !signal->program) return;
  if (!player_.play(std::make_shared<const playback::PressTrace>(signal->press)))
    emit panel_.statusMessage(settings_.sound ? FeelPanel::tr("One press at a time")
                                              : FeelPanel::tr("Switch the sound on to play a press"));
  showPresses();
}

void FeelPanel::Parts::showPresses() {
  myPress_->setEnabled(ownPress_ != nullptr);
  const bool playable = felt().signal && felt().signal->program && settings_.sound && !player_.playing();
  if (play_->isEnabled() != playable) play_->setEnabled(playable);
}

void FeelPanel::Parts::feel(std::size_t index) {
  if (!slots_[index].document) {
    felt().choice->setChecked(true);
    return;
  }
  if (index == feltIndex_) return;
  if (wasPressed_) {  // the point leaves the graph of the one that was pressed
    emit(feltIndex_ == 0 ? panel_.fingerMoved(std::nullopt) : panel_.otherFingerMoved(std::nullopt));
  }
  feltIndex_ = index;
  showFelt();
  emit panel_.feltDocumentChanged(felt().document);
  emit panel_.statusMessage(FeelPanel::tr("Pressing %1, at its true level").arg(felt().document->title()));
}

double FeelPanel::Parts::full_N() {
  if (settings_.full_N > 0) return settings_.full_N;
  return felt().signal && felt().signal->program ? fullForceOf(*felt().signal->program) : 1;
}

void FeelPanel::Parts::showFelt() {
  const Slot& slot = felt();
  slot.choice->setChecked(true);
  view_->setSignal(slot.signal);
  const bool playable = slot.document && slot.signal && slot.signal->program;
  player_.setProgram(playable ? slot.signal->program : nullptr);
  shownState_ = 0;  // a program begins in its first state
  showPad();
  showPresses();
}

void FeelPanel::Parts::showPad() {
  const Slot& slot = felt();
  if (!slot.document || !slot.signal || !slot.signal->program) {
    const bool failed = slot.signal && slot.signal->failure;
    pad_->setButton(std::nullopt, failed ? FeelPanel::tr("This button cannot be pressed: %1")
                                               .arg(QString::fromStdString(slot.signal->failure->sentence()))
                                         : QString());
    return;
  }
  if (!playback::livePlaybackAvailable()) {
    pad_->setButton(std::nullopt,
                    FeelPanel::tr("This build of Detent has no live playback, so the pad cannot be "
                                  "pressed. The vibration is drawn below."));
    return;
  }
  PadButton button = padButtonOf(slot.document->button(), shownState_, full_N());
  if (button.name.isEmpty()) button.name = slot.document->title();
  pad_->setButton(std::move(button));
}

// ---- settings

void FeelPanel::Parts::setSettings(const FeelSettings& settings) {
  const FeelSettings before = std::exchange(settings_, settings);
  pad_->setDrive(settings.drive);
  const QSignalBlocker soundBlocked(sound_), gainBlocked(gain_);
  sound_->setChecked(settings.sound);
  gain_->setValue(static_cast<int>(std::lround(settings.gain_dB * gainStepsPer_dB)));
  gainText_->setText(FeelPanel::tr("%1 dB").arg(fixedText(settings.gain_dB, 1).replace('-', QChar(0x2212))));
  player_.setGain(gainOf(settings.gain_dB));
  player_.setSoundWanted(settings.sound);
  const playback::PlayerSettings output{settings.device.toStdString(), settings.rate_Hz, settings.buffer};
  if (settings.device != before.device || settings.rate_Hz != before.rate_Hz ||
      settings.buffer != before.buffer)
    player_.setOutput(output);
  const bool profileChanged = settings.profileFile != before.profileFile;
  if (profileChanged) loadProfile();
  if (settings_.sensorPort != before.sensorPort || settings_.sensorBaud != before.sensorBaud ||
      (profileChanged && !settings_.sensorPort.isEmpty()))
    connectSensor();
  if (profileChanged || settings.mode != before.mode || settings.placement != before.placement)
    for (Slot& slot : slots_) request(slot);
  if (settings.full_N != before.full_N) showPad();
  if (!(setup_->settings() == settings_) || profileChanged || settings_.sensorPort != before.sensorPort)
    setup_->setSettings(settings_);
  showStatus();
}

void FeelPanel::Parts::loadProfile() {
  profile_.reset();
  QString trouble;
  if (!settings_.profileFile.isEmpty()) {
    Result<playback::DeviceProfile> loaded = playback::loadDeviceProfile(settings_.profileFile.toStdString());
    if (loaded) {
      profile_ = *std::move(loaded);
    } else {
      trouble = QString::fromStdString(loaded.failure().sentence());
      settings_.profileFile.clear();
    }
  }
  setup_->setProfile(profile_, trouble);
  if (!trouble.isEmpty()) emit panel_.statusMessage(trouble);
}

void FeelPanel::Parts::connectSensor() {
  SensorPort sensor;
  sensor.port = settings_.sensorPort.toStdString();
  sensor.baud = settings_.sensorBaud;
  if (profile_) sensor.calibration = profile_->sensor;
  player_.setSensor(sensor);
}

// ---- following

void FeelPanel::Parts::follow() {
  const playback::PlayerStatus& s = player_.status();
  const double now_s = steady_s();
  const bool pressed = player_.pressed();
  followState(static_cast<std::size_t>(s.state));
  // A finger that trembles at one place turns the engine's stroke to and fro; it has turned for the eye once
  // it moves.
  if (!pressed || s.displacement_mm != lastDisplacement_mm_) releasing_ = s.releasing;
  lastDisplacement_mm_ = s.displacement_mm;
  pad_->setMotion({s.displacement_mm, s.force_N, pressed, releasing_, s.contact});
  if (pressed) lastPressed_s_ = now_s;
  if (now_s - lastPressed_s_ < stripTail_s && felt().signal && felt().signal->program) {
    const playback::StateProgram& state = felt().signal->program->states[shownState_];
    const double travel_mm = state.end_mm - state.start_mm;
    const double depth = travel_mm > 0 ? (s.displacement_mm - state.start_mm) / travel_mm : 0;
    strip_->addMoment({now_s, depth, releasing_, s.contact});
  }
  if (pressed || wasPressed_) {
    std::optional<FingerPosition> finger;
    const ButtonDocument* document = felt().document;
    // A point of one state says nothing on the graph of the other.
    if (pressed && document != nullptr && document->activeState() == shownState_)
      finger = FingerPosition{s.displacement_mm, s.force_N, releasing_ ? Stroke::release : Stroke::press};
    if (feltIndex_ == 0) {
      emit panel_.fingerMoved(finger);
    } else {
      emit panel_.otherFingerMoved(finger);
    }
  }
  wasPressed_ = pressed;
  showStatus();
}

void FeelPanel::Parts::followState(std::size_t state) {
  ButtonDocument* document = felt().document;
  if (document == nullptr || state >= document->button().states().size()) return;
  const bool turned = state != shownState_;
  if (turned) {
    shownState_ = state;
    showPad();
  }
  if (!settings_.followState || document->history().dragging() || document->activeState() == state) return;
  if (turned || player_.pressed()) document->setActiveState(state);
}

void FeelPanel::Parts::onFelt(const std::vector<playback::EngineEvent>& events) {
  using playback::EventKind;
  for (const playback::EngineEvent& event : events) {
    if (event.kind == EventKind::pressJump) pad_->flash(PressPad::Lamp::pressJump);
    if (event.kind == EventKind::releaseJump) pad_->flash(PressPad::Lamp::releaseJump);
    if (event.kind == EventKind::bottomOut) pad_->flash(PressPad::Lamp::bottomOut);
  }
  const double rate_Hz = player_.status().sampleRate_Hz;
  strip_->addEvents(events, steady_s(), rate_Hz > 0 ? rate_Hz : drawnRate_Hz);
}

void FeelPanel::Parts::showSound() {
  again_->setVisible(player_.sound() == SoundState::failed);
  if (player_.sound() == SoundState::lost || player_.sound() == SoundState::failed)
    emit panel_.statusMessage(FeelPanel::tr("No sound: the finger is followed silently"));
  showStatus();
}

void FeelPanel::Parts::showStatus() {
  const playback::PlayerStatus& s = player_.status();
  QString text;
  switch (player_.sound()) {
    case SoundState::off:
      text = settings_.sound ? FeelPanel::tr("Sound starts with the first press.")
                             : FeelPanel::tr("Sound is off; the finger is followed silently.");
      break;
    case SoundState::starting:
      text = FeelPanel::tr("Opening the sound device; the finger is followed silently until then.");
      break;
    case SoundState::on:
      text = FeelPanel::tr("%1 · %2 kHz")
                 .arg(QString::fromStdString(s.device), numberText(s.sampleRate_Hz / 1000));
      if (s.blockFrames > 0 && s.sampleRate_Hz > 0)
        text += FeelPanel::tr(" · buffer %1 (%2 ms)")
                    .arg(s.blockFrames)
                    .arg(fixedText(1000 * s.blockFrames / s.sampleRate_Hz, 1));
      text += FeelPanel::tr(" · load %1 %").arg(fixedText(100 * s.meanLoad, 1)) +
              FeelPanel::tr(" · drop-outs: %1").arg(s.xruns);
      break;
    case SoundState::lost:
      text = FeelPanel::tr(
                 "The sound device %1 is gone. Plug it in or start its server again: sound goes on by "
                 "itself. Until then the finger is followed silently.")
                 .arg(QString::fromStdString(s.device));
      break;
    case SoundState::failed:
      text = FeelPanel::tr("No sound: %1 The finger is followed silently.").arg(player_.trouble());
      break;
  }
  if (s.deviceLosses > 0 && player_.sound() == SoundState::on)
    text += FeelPanel::tr(" · losses: %1").arg(s.deviceLosses);
  // Figures change all the time; they are read, not watched.
  const bool figures = player_.sound() == SoundState::on && shownSound_ == SoundState::on;
  if (text != status_->text() && (!figures || steady_s() - figuresAt_s_ > figuresEvery_s)) {
    status_->setText(text);
    figuresAt_s_ = steady_s();
    shownSound_ = player_.sound();
  }

  if (player_.sound() == SoundState::on) {
    const double ceiling =
        felt().signal && felt().signal->program ? felt().signal->program->limiterCeiling : 1;
    meter_->setLevel(s.level, ceiling, steady_s());
    setup_->setBuffer(s.blockFrames);
  } else {
    meter_->setIdle();
  }
  setup_->setSensor(s, player_.sensorTrouble());
  showPresses();
}

// ---- panel

FeelPanel::FeelPanel(ViewSettings& settings, QWidget* parent, const FeelDevices& devices) : QWidget(parent) {
  setAccessibleName(tr("Feel"));
  parts_ = std::make_unique<Parts>(*this, settings, devices);
}
FeelPanel::~FeelPanel() = default;

void FeelPanel::setDocument(ButtonDocument* document) { parts_->setDocument(0, document); }
void FeelPanel::setOther(ButtonDocument* other) { parts_->setDocument(1, other); }
ButtonDocument* FeelPanel::feltDocument() const { return parts_->felt().document; }
void FeelPanel::exchange() { parts_->feel(1 - parts_->feltIndex_); }
QAction* FeelPanel::exchangeAction() const { return parts_->exchange_; }

QVariantMap FeelPanel::saveState() const {
  QVariantMap state = toMap(parts_->settings_);
  state["setupShown"] = parts_->setupToggle_->isChecked();
  return state;
}

void FeelPanel::restoreState(const QVariantMap& state) {
  FeelSettings settings = feelSettingsFrom(state);
  const QString port = std::exchange(settings.sensorPort, QString());
  parts_->setSettings(settings);
  if (!port.isEmpty()) parts_->setup_->offerPort(port);
  parts_->setupToggle_->setChecked(state.value("setupShown").toBool());
}

void FeelPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  for (Parts::Slot& slot : parts_->slots_)
    if (slot.stale) parts_->request(slot);
}

void FeelPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  parts_->layOut();
}

}  // namespace detent::editor
