"""The mean velocity across a channel at nu = 0.56 (thesis, fig. 3.1): flow.png, or numbers without matplotlib."""
import gpf

flow = gpf.run("""[scene]
geometry = "channel"
particles = 900
area_fraction = 0.56
width_over_diameter = 31
normal_restitution = 0.99
wall_tangential_restitution = 0.9
[run]
start_up = 40
duration = 20""")
U, error = flow.quantities["mean_velocity"]
try:
    import matplotlib.pyplot as plt
    plt.errorbar(flow.bins, U, error, fmt="o", capsize=2)
    plt.xlabel("y/W")
    plt.ylabel("U / sqrt(g W)")
    plt.savefig("flow.png")
except ImportError:
    for row in zip(flow.bins, U, error):
        print("%.3f %.4f %.4f" % row)
