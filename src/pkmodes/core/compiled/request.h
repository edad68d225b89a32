/* A request to the compiled evaluator: inputs and outputs.  `pkmodes.core.compiled.loader` mirrors it in Python. */
#ifndef PKMODES_REQUEST_H
#define PKMODES_REQUEST_H

/* Version of the layout below; a library with another version is not used. */
#define PKMODES_LAYOUT 8

struct pkmodes_request {
    /* N poses, row-major. */
    long long count;
    const double *poses;
    /* The robot: parameters and effects, flat, in the order of their fields. */
    const double *parameters;
    const double *effects;
    double largest_condition;
    /* With effects: the stiffness of each released joint, the coordinates that are not locked, and which of these have
     * no inertia; without them `free_count` is 0. */
    const double *joints;
    const int *free;
    const signed char *massless;
    long long free_count;
    /* Coordinates that are not free but follow others: coordinate `following[i]` is `fold_weights[i]` times `leading[i]`. */
    const int *leading, *following;
    const double *fold_weights;
    long long fold_count;
    /* Several robots with the same free coordinates: robot r has N / robots poses, from pose r N / robots on, and row r of
     * the parameters, effects and joint stiffnesses, which are so long. */
    long long robots, parameter_count, effect_count, joint_count;
    /* Derivatives along T paths: path t has the terms from `first_term[t]` to before `first_term[t + 1]`, each a place
     * in the gradient (parameters, effects, pose, joints) and its weight.  `all_coordinates`: the
     * model with effects is differentiated also if the robot has none; `locked_joints`: there are terms of such joints. */
    long long path_count;
    const int *first_term;
    const int *places;
    const double *weights;
    long long all_coordinates, locked_joints;
    /* Several robots: row r of `first_term`, so long, or 0 if all have the same paths. */
    long long term_count;
    /* Modes whose derivatives along the paths are wanted, m at each pose; m may be 0. */
    const double *given_eigenvalues, *given_shapes; /* (N, m), (N, m, n) */
    long long modes;
    long long rigid_modes;
    /* Results, n coordinates and m of them with inertia; NULL where not wanted.  A pose that cannot be evaluated gives
     * NaN. */
    double *frequencies;      /* (N, m) [Hz] */
    double *eigenvalues;      /* (N, m) [1/s^2] */
    double *shapes;           /* (N, m, n) */
    double *platform_shapes;  /* (N, m, directions) */
    double *vibration_amplitudes; /* (N, m, linear directions) [s^2]; NaN for the first `rigid_modes` */
    double *joint_positions;  /* (N, independent) */
    double *platform_motion;  /* (N, directions, n) */
    double *platform_jacobian; /* (N, components of the pose, independent) */
    double *static_torque;    /* (N, drives) */
    double *static_rotation;  /* (N, dependent) */
    double *elastic_stiffness; /* (N, base coordinates, base coordinates): K without effects and gravity */
    double *mass;             /* (N, n, n) */
    double *stiffness;        /* (N, n, n) */
    double *eigenvalue_rates; /* (N, T, m) [1/s^2 per unit] */
    double *frequency_rates;  /* (N, T, m) [Hz per unit]; NaN where the frequency is zero to rounding */
    double *changes;          /* (N, T, m, n): (dK - lambda dM) phi, without terms of locked joints */
    double *mode_rates;       /* (N, T, m): phi^T (dK - lambda dM) phi */
    double *norms;            /* (N, T, m): phi^T dM phi */
    double *motions;          /* (N, T, m, directions): dJ phi, J the motion of the platform */
    double *mass_rates, *stiffness_rates; /* (N, T, n, n): dM and dK, without terms of locked joints */
    double *mass_of_all, *stiffness_of_all; /* (N, e, e): M and K in all coordinates, without the springs of joints */
    /* Always written: 0 where a pose was evaluated, 1 where it is not finite, from 2 on the violated margin, and -1
     * where the eigenproblem needs another solver. */
    signed char *codes; /* (N) */
};

#endif
