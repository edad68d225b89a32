"""Sizes of the causes in the suites, found by `strengths` from the predicted signal, not from any diagnosis.

The sizes of pairs and of causes outside the catalogue were recomputed at the poses of each case, after a first run in
which some of them gave too small a signal (a few were invisible).

All sizes are in SI units.  Two kinds of causes are special.  A cause that ties the robot to ground (`TYING`) makes
rigid modes measurable, which the declared model lacks completely: 300 sigma each, however weak the tie.  Its size is
chosen from the signal in the other modes.  A cause that adds a mode (frame compliance, an absorber) becomes visible
only when that mode is among the six lowest at some pose, so its three sizes are close together.
"""

from __future__ import annotations

#: Signals of the three sizes of an effect: hidden, barely visible, clear.
TARGETS = (3.0, 8.0, 25.0)
#: The same for wrong declared values and for causes outside the catalogue.
WRONG_TARGETS = (7.0, 12.0, 25.0)
OUTSIDE_TARGETS = (20.0, 50.0)

#: Number of pairs of effects, and the range of the signal of each alone: clearly visible.
PAIRS, PAIR_TARGETS = 24, (10.0, 25.0)

#: Relative sizes of the factors of a group, such as `axis_belt_stiffness`: all different, some of opposite sign.
UNEQUAL = (0.5, -1.0, 0.3, 0.1, -0.4, 0.8)

#: Causes of the rig that no combination in the catalogue can represent.  Left out are `rod_taper`, which is exactly a
#: payload with a wrong carriage mass (mass moved from one end of a rod to the other), and `thermal_drift`, which is
#: a measurement error and not a property of the robot: both are special cases.
KINDS = (
    "tuned_absorber",
    "directional_cable",
    "hose",
    "worn_belt",
    "bellows",
    "rocking_frame",
    "one_gearbox",
    "pulley_mount",
    "one_servo",
    "one_span",
    "leaning_frame",
)

#: Causes that tie a robot to ground, of all mechanisms.
TYING = (
    *(
        "servo_stiffness",
        "cable_stiffness",
        "directional_cable",
        "hose",
        "bellows",
        "one_servo",
        "arm_hose",
        "leg_hose",
    ),
)

#: Sizes of the effects in SI units, for each of `TARGETS`.
EFFECT_SIZES: dict[str, dict[str, tuple[float, float, float]]] = {
    "published": {
        "axis_belt_stiffness": (0.00259, 0.00694, 0.0216),
        "belt_end_compliance": (4.21e-08, 1.13e-07, 3.67e-07),
        "belt_mass": (0.00301, 0.00833, 0.0296),
        "cable_stiffness": (12500, 32300, 95400),
        "gearbox_inertia": (0.000103, 0.000276, 0.000879),
        "payload": (0.23, 0.673, 3.38),
        "servo_stiffness": (2.88, 7.72, 24.1),
        "gearbox_compliance": (3.99e-05, 0.000107, 0.000345),
        "link_compliance": (6.08e-08, 1.56e-07, 3.96e-07),
        "clamp_compliance": (3.94e-08, 1.06e-07, 3.44e-07),
        "frame_compliance": (1.46e-08, 1.91e-08, 2.01e-08),
    },
    "tower": {
        "axis_belt_stiffness": (0.00318, 0.00853, 0.0252),
        "belt_end_compliance": (9.22e-07, 2.52e-06, 8.58e-06),
        "belt_mass": (0.00032, 0.000875, 0.00301),
        "cable_stiffness": (6720, 14800, 29900),
        "gearbox_inertia": (3e-07, 8.04e-07, 2.53e-06),
        "payload": (0.043, 0.107, 0.312),
        "servo_stiffness": (0.014, 0.0378, 0.129),
        "gearbox_compliance": (0.0243, 0.0659, 0.215),
        "link_compliance": (3.79e-07, 8.92e-07, 1.18e-06),
        "clamp_compliance": (7.5e-07, 2.03e-06, 6.76e-06),
        "frame_compliance": (7.77e-09, 7.94e-09, 8.29e-09),
    },
    "asymmetric": {
        "axis_belt_stiffness": (0.00243, 0.0065, 0.0203),
        "belt_end_compliance": (9.69e-08, 2.62e-07, 8.55e-07),
        "belt_mass": (0.00412, 0.0113, 0.0392),
        "cable_stiffness": (10800, 27800, 77700),
        "gearbox_inertia": (1.63e-05, 4.38e-05, 0.000138),
        "payload": (0.161, 0.503, 2.44),
        "servo_stiffness": (0.811, 2.17, 7.0),
        "gearbox_compliance": (0.000574, 0.00155, 0.00495),
        "link_compliance": (1.76e-07, 3.67e-07, 6.31e-07),
        "clamp_compliance": (8.69e-08, 2.35e-07, 7.75e-07),
        "frame_compliance": (7.94e-09, 8.66e-09, 9.34e-09),
    },
}

#: Changes of wrong declared values, in SI units: quantities of the tables, of the axes as wholes, and of one axis,
#: with alternating sign and each of `WRONG_TARGETS` in turn.
WRONG_SIZES: dict[str, dict[str, float]] = {
    "published": {
        "link.mass": 0.256,  # 37 %
        "carriage.mass": -0.119,  # -12 %
        "link.length": 0.00646,  # 1.6 %
        "pulley.radius": -0.00109,  # -3.1 %
        "belt.width": 0.00359,  # 24 %: up to 2 % could be due to the specific stiffness
        "motor.gear_ratio": -2.94,  # -29 %
        "axis.span": 0.00731,  # 0.61 %
        "pulley.inertia": -1.04e-05,  # -8 %
        "carriage.length": 0.0234,  # declared as 0
    },
    "tower": {
        "carriage.mass": 0.0112,  # 7.5 %
        "link.mass": -0.0222,  # -37 %
        "pulley.radius": 0.000525,  # 8.8 %
        "link.length": -0.00454,  # -1.5 %
        "motor.gear_ratio": 0.115,  # 12 %
        "belt.width": -0.003,  # -50 %
        "axis.joint_radius": 0.00442,  # 15 %
        "axis.span": -0.0411,  # -4.6 %
        "carriage.length": 0.0673,  # 170 %
    },
    "asymmetric": {
        "link.mass": 0.16,  # 52 %
        "axis.3.carriage.mass": -0.109,  # -14 %
        "axis.2.belt.width": 0.000352,  # 2.9 %
        "motor.gear_ratio": -0.218,  # -7.3 %
        "axis.3.link.length": 0.00451,  # 1 %
        "axis.span": -0.0464,  # -5.8 %
        "carriage.mass": 0.0489,  # 7.5 %
        "pulley.radius": -0.00136,  # -6.8 %
        "pulley.inertia": 1.27e-05,  # 28 %
    },
}

#: An absorber adds a mode among the six lowest, however light it is, which alone gives about 100 sigma: its mass
#: relative to the platform's, for each of `OUTSIDE_TARGETS`.
ABSORBER = {20.0: 0.03, 50.0: 0.1}

#: Sizes of the causes outside the catalogue, in the order of `strengths.outside_causes`.
OUTSIDE_SIZES: tuple[float, ...] = (
    0.045,  # tuned_absorber, published, grid
    0.15,  # tuned_absorber, published, scattered
    0.03,  # tuned_absorber, tower, line
    0.027,  # tuned_absorber, asymmetric, grid
    1.73e05,  # directional_cable, published, scattered
    1.76e04,  # directional_cable, tower, line
    7.92e04,  # directional_cable, asymmetric, grid
    1.6e05,  # directional_cable, asymmetric, scattered
    2.86e04,  # hose, published, line
    1.46e04,  # hose, tower, grid
    2.65e04,  # hose, tower, scattered
    1.74e04,  # hose, asymmetric, line
    0.144,  # worn_belt, published, grid
    0.37,  # worn_belt, published, scattered
    0.217,  # worn_belt, tower, line
    0.229,  # worn_belt, asymmetric, grid
    2.23e04,  # bellows, published, scattered
    1.37e04,  # bellows, tower, line
    2.41e04,  # bellows, asymmetric, grid
    6.52e04,  # bellows, asymmetric, scattered
    2.82e-07,  # rocking_frame, published, line
    1.16e-07,  # rocking_frame, tower, grid
    1.09e-07,  # rocking_frame, tower, scattered
    2.2e-07,  # rocking_frame, asymmetric, line
    0.000249,  # one_gearbox, published, grid
    0.000624,  # one_gearbox, published, scattered
    0.214,  # one_gearbox, tower, line
    0.00145,  # one_gearbox, asymmetric, grid
    7.03e-07,  # pulley_mount, published, scattered
    9.99e-06,  # pulley_mount, tower, line
    1.1e-06,  # pulley_mount, asymmetric, grid
    2.22e-06,  # pulley_mount, asymmetric, scattered
    23.3,  # one_servo, published, line
    0.0687,  # one_servo, tower, grid
    0.139,  # one_servo, tower, scattered
    1.75,  # one_servo, asymmetric, line
    2.69e-06,  # one_span, published, grid
    7.22e-06,  # one_span, published, scattered
    1.66e-05,  # one_span, tower, line
    8.68e-06,  # one_span, asymmetric, grid
    2.01e-08,  # leaning_frame, published, scattered
    9.54e-09,  # leaning_frame, tower, line
    1.09e-08,  # leaning_frame, asymmetric, grid
    9.97e-09,  # leaning_frame, asymmetric, scattered
)

#: Sizes of the two effects of each pair, in the order of `strengths.pairs`.
PAIR_SIZES: tuple[tuple[float, float], ...] = (
    (3.367e-07, 4.876e04),  # link_compliance + cable_stiffness
    (2.507e-06, 9.239e-09),  # gearbox_inertia + frame_compliance
    (5.601e-07, 0.6956),  # clamp_compliance + payload
    (0.01094, 1.478e-07),  # axis_belt_stiffness + belt_end_compliance
    (0.1665, 0.002396),  # payload + belt_mass
    (8.942e-05, 7.423e-07),  # gearbox_inertia + belt_end_compliance
    (22.8, 6.747e04),  # servo_stiffness + cable_stiffness
    (0.155, 0.01403),  # gearbox_compliance + axis_belt_stiffness
    (4.414e-07, 0.9944),  # belt_end_compliance + payload
    (1.938e-07, 3.727),  # clamp_compliance + payload
    (2.438e04, 0.01344),  # cable_stiffness + axis_belt_stiffness
    (4.03, 0.02653),  # servo_stiffness + belt_mass
    (2.568e-07, 4.281e04),  # link_compliance + cable_stiffness
    (0.01762, 8.201e-09),  # axis_belt_stiffness + frame_compliance
    (0.004442, 4.395),  # gearbox_compliance + servo_stiffness
    (3.259e-07, 1.702e-07),  # belt_end_compliance + clamp_compliance
    (0.002585, 0.06435),  # belt_mass + servo_stiffness
    (0.03478, 0.002975),  # belt_mass + gearbox_compliance
    (0.02068, 0.0002601),  # belt_mass + gearbox_compliance
    (3.301e04, 0.2073),  # cable_stiffness + servo_stiffness
    (4.54, 0.8007),  # servo_stiffness + payload
    (1.93e-08, 13.12),  # frame_compliance + servo_stiffness
    (3.687e-06, 0.0603),  # belt_end_compliance + servo_stiffness
    (5.601e-07, 0.01478),  # link_compliance + belt_mass
)
