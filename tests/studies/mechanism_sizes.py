"""Sizes of the causes in `mechanism_suites`, computed by ``python -m studies.mechanism_suites --sizes``.

They are chosen from the predicted signal, not from any diagnosis; all in SI units.
"""

from __future__ import annotations

SIZES: dict[str, dict[str, dict[str, list[float]]]] = {
    "rotary_delta": {
        "one effect": {
            "axis_reducer_stiffness": [0.0206, 0.0347, 0.0609],
            "cable_stiffness": [3500.0, 6150.0, 11300.0],
            "gearbox_inertia": [0.00417, 0.00732, 0.014],
            "payload": [0.0535, 0.0981, 0.205],
            "servo_stiffness": [310.0, 544.0, 998.0],
            "link_compliance": [3.6e-07, 6.32e-07, 1.06e-06],
            "frame_compliance": [6e-08, 1.4e-07, 4e-07],
            "one alone": [0.0292, 0.049, 0.0756],
        },
        "wrong parameter": {
            "arm.length": [0.00474],
            "arm.inertia": [-0.00102],
            "link.length": [0.0199],
            "link.mass": [-0.0232],
            "motor.inertia": [7e-06],
            "motor.gear_ratio": [-3.1],
            "axis.joint_radius": [0.00555],
            "axis.1.origin.z": [-0.0172],
            "axis.2.arm.length": [0.0319],
            "axis.2.motor.inertia": [-3.65e-06],
        },
        "outside the catalogue": {
            "tuned_absorber": [0.01, 0.03],
            "directional_cable": [16700.0, 34800.0],
            "one_servo": [1240.0, 2370.0],
            "arm_hose": [839.0, 1830.0],
            "one_link": [8.61e-07, 2.05e-06],
            "rocking_frame": [1e-07, 5e-07],
        },
    },
    "corexy": {
        "one effect": {
            "axis_belt_stiffness": [0.0166, 0.0292, 0.0535],
            "belt_end_compliance": [6.84e-07, 1.26e-06, 2.3e-06],
            "belt_mass": [0.0636, 0.145, 0.487],
            "cable_stiffness": [43200.0, 72700.0, 122000.0],
            "gearbox_inertia": [2.03e-06, 4.44e-06, 1.43e-05],
            "payload": [0.102, 0.196, 0.487],
            "servo_stiffness": [0.172, 0.302, 0.555],
            "gearbox_compliance": [0.0171, 0.0314, 0.0575],
            "clamp_compliance": [6.55e-07, 1.15e-06, 2.2e-06],
            "frame_compliance": [3e-08, 6e-08, 1.5e-07],
            "one alone": [0.0245, 0.0431, 0.0756],
        },
        "wrong parameter": {
            "belt.width": [0.0049],
            "pulley.radius": [-0.00162],
            "pulley.inertia": [3e-07],
            "motor.inertia": [-1.43e-06],
            "motor.gear_ratio": [0.344],
            "belt_path.1.lengths.1": [-0.0211],
            "belt_path.1.lengths.2": [0.0457],
            "belt_path.2.lengths.1": [-0.0209],
            "belt_path.2.pulley.radius": [0.000341],
            "belt_path.2.motor.inertia": [-1.87e-07],
        },
        "outside the catalogue": {
            "tuned_absorber": [0.02, 0.06],
            "directional_cable": [82800.0, 189000.0],
            "one_servo": [0.316, 0.855],
            "one_gearbox": [0.0222, 0.0575],
            "one_run": [1.22e-06, 3.3e-06],
            "racking_gantry": [4e-05, 0.0001],
        },
    },
}
